"""The learned predictors: what each is told, what it is to predict, and how it learns."""

import numpy as np
from sklearn.ensemble import HistGradientBoostingClassifier, HistGradientBoostingRegressor
from sklearn.neural_network import MLPRegressor
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler

import samples

LIFTED = 0.999  # of the true load transfer
SEED = 1
# Moments at which nothing is near teach little: of those, a share.
CALM_LTR, CALM_SHARE = 0.3, 0.1
KEPT_SHARE = 0.4  # of all: neighbouring cycles are alike
LARGEST = 120_000  # rows that are learned from


class LoadAhead:
    """Predicts the largest load transfer within the horizon; `without` says what it is not told."""

    def __init__(self, model, horizon_s, without=()):
        self.horizon_s = horizon_s
        self._model = model
        self._told = [k for k, group in enumerate(samples.groups()) if group not in without]

    def learn(self, told, ahead):
        self._model.fit(told[:, self._told], self._lesson(ahead))

    def risk(self, told):
        return self._model.predict(told[:, self._told])

    def _lesson(self, ahead):
        return ahead


class LiftAhead(LoadAhead):
    """Predicts how probable lift-off is within the horizon."""

    def risk(self, told):
        return self._model.predict_proba(told[:, self._told])[:, 1]

    def _lesson(self, ahead):
        return ahead >= LIFTED


def _trees(kind):
    return kind(max_iter=100, max_leaf_nodes=31, min_samples_leaf=50, early_stopping=False, random_state=SEED)


def _perceptron():
    return make_pipeline(StandardScaler(), MLPRegressor((48, 24), batch_size=512, max_iter=12, random_state=SEED))


# The name in the report -> a new predictor.
LEARNED = {
    "boosted trees, signals only": lambda: LoadAhead(_trees(HistGradientBoostingRegressor), 0.3, samples.OF_FIRMWARE),
    "boosted trees": lambda: LoadAhead(_trees(HistGradientBoostingRegressor), 0.3),
    "boosted trees, lift-off": lambda: LiftAhead(_trees(HistGradientBoostingClassifier), 0.4),
    "perceptron": lambda: LoadAhead(_perceptron(), 0.3),
}


def lessons(runs, predictor):
    """(told, ahead): rows of these runs, of both sides, before any two wheels have lifted."""
    random = np.random.default_rng(SEED)
    told, ahead = [], []
    for run in runs:
        right = samples.rows(run)
        for rows, coming in zip((right, samples.seen_from_left(right)), samples.coming(run, predictor.horizon_s)):
            coming = coming[:samples.until_lift(run):samples.STRIDE]
            kept = (coming > CALM_LTR) | (random.random(len(coming)) < CALM_SHARE)
            kept &= random.random(len(coming)) < KEPT_SHARE
            told.append(rows[kept])
            ahead.append(coming[kept])
    told, ahead = np.concatenate(told), np.concatenate(ahead)
    chosen = np.sort(random.permutation(len(ahead))[:LARGEST])
    return told[chosen], ahead[chosen]


def learned(name, runs):
    predictor = LEARNED[name]()
    predictor.learn(*lessons(runs, predictor))
    return predictor


def predictions(predictor, runs):
    """Run -> (right, left), a risk for each cycle until lift-off."""
    return {run: _prediction(predictor, run) for run in runs}


def _prediction(predictor, run):
    right = samples.rows(run)
    both = predictor.risk(np.concatenate([right, samples.seen_from_left(right)])).astype(float)
    end = samples.until_lift(run)
    return tuple(np.repeat(side, samples.STRIDE)[:end].tolist() for side in np.split(both, 2))
