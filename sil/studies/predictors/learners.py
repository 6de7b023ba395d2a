"""The learned predictors: inputs, target and training of each."""

import warnings

import numpy as np
from sklearn.ensemble import HistGradientBoostingRegressor
from sklearn.exceptions import ConvergenceWarning
from sklearn.linear_model import Ridge
from sklearn.neural_network import MLPRegressor
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler

import samples

SEED = 1
# Moments at which nothing is near teach little: of those, a share.
CALM_LTR, CALM_SHARE = 0.3, 0.1
KEPT_SHARE = 0.4  # of all: neighbouring cycles are alike
LARGEST = 120_000  # rows that are learned from


class LoadAhead:
    """Predicts the largest load transfer within the horizon; `without` names the omitted inputs."""

    def __init__(self, model, horizon_s, without=()):
        self.horizon_s = horizon_s
        self._model = model
        self._told = [k for k, group in enumerate(samples.groups()) if group not in without]

    rows = staticmethod(samples.rows)
    seen_from_left = staticmethod(samples.seen_from_left)

    def learn(self, told, ahead):
        self._model.fit(told[:, self._told], ahead)

    def risk(self, told):
        return self._model.predict(told[:, self._told])


class LinearForecast:
    """The firmware's: a weighted sum of its own inputs, without a constant, so that left is right with the other sign."""

    horizon_s = 0.3
    rows = staticmethod(samples.forecast_rows)
    seen_from_left = staticmethod(np.negative)

    def __init__(self):
        self._model = make_pipeline(StandardScaler(with_mean=False), Ridge(1.0, fit_intercept=False))

    def learn(self, told, ahead):
        self._model.fit(told, ahead)

    def risk(self, told):
        return self._model.predict(told)

    def weights(self):
        """One for each input."""
        return self._model[-1].coef_ / self._model[0].scale_


def _trees():
    return HistGradientBoostingRegressor(max_iter=100, max_leaf_nodes=31, min_samples_leaf=50, early_stopping=False,
                                         random_state=SEED)


def _perceptron():
    warnings.simplefilter("ignore", ConvergenceWarning)  # so many rounds are enough, and all that time allows
    layers = MLPRegressor(hidden_layer_sizes=(48, 24), batch_size=512, max_iter=12, random_state=SEED)
    return make_pipeline(StandardScaler(), layers)


TREES, FORECAST = "boosted trees", "the linear forecast alone"
# The name in the report -> a new predictor.
LEARNED = {
    FORECAST: LinearForecast,
    TREES: lambda: LoadAhead(_trees(), 0.3),
    f"{TREES}, 0.2 s": lambda: LoadAhead(_trees(), 0.2),
    f"{TREES}, signals only": lambda: LoadAhead(_trees(), 0.3, samples.OF_FIRMWARE),
    "perceptron": lambda: LoadAhead(_perceptron(), 0.3),
}


def lessons(runs, predictor):
    """(told, ahead): rows of these runs, of both sides, before any two wheels have lifted."""
    random = np.random.default_rng(SEED)
    told, ahead = [], []
    for run in runs:
        right = predictor.rows(run)
        for rows, coming in zip((right, predictor.seen_from_left(right)), samples.coming(run, predictor.horizon_s)):
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
    right = predictor.rows(run)
    both = predictor.risk(np.concatenate([right, predictor.seen_from_left(right)])).astype(float)
    end = samples.until_lift(run)
    return tuple(np.repeat(side, samples.STRIDE)[:end].tolist() for side in np.split(both, 2))
