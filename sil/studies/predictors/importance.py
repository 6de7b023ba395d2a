"""Importance of a learned predictor's inputs: how much worse it gets when a group of its numbers is that of other moments."""

import numpy as np

import learners
import samples

NEAR = 0.6  # of the coming load transfer: below it no forecast is needed


def by_group(predictor, runs):
    """Group -> mean error of the coming load transfer without it, over that with all; the largest first."""
    told, ahead = learners.lessons(runs, predictor)
    near = ahead > NEAR
    told, ahead = told[near], ahead[near]
    random = np.random.default_rng(learners.SEED)
    with_all = _error(predictor, told, ahead)
    names = samples.groups()
    result = {}
    for group in dict.fromkeys(names):
        exchanged = told.copy()
        of_group = [k for k, name in enumerate(names) if name == group]
        exchanged[:, of_group] = told[random.permutation(len(told))][:, of_group]
        result[group] = _error(predictor, exchanged, ahead) / with_all
    return dict(sorted(result.items(), key=lambda item: -item[1]))


def _error(predictor, told, ahead):
    return float(np.mean(np.abs(predictor.risk(told) - ahead)))
