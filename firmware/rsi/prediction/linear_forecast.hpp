// Linear forecast: the load transfer 0.3 s ahead as a weighted sum of what the sensors say now and said a
// moment ago. Its weights are learnt from simulated vehicles and are the same for every vehicle.
#pragma once

#include "rsi/measurement/measurement.hpp"
#include "rsi/model/vehicle.hpp"
#include "rsi/numeric/matrix.hpp"
#include "rsi/prediction/steering_demand.hpp"
#include "rsi/types.hpp"

namespace rsi {

// A row for each signal (force, roll rate, roll angle, yaw, steering), a column for each lag.
using ForecastMatrix = Matrix5x3;

class LinearForecast {
 public:
    // The next sample starts the lags where the signals are.
    void reset() { running_ = false; }

    // One sample. Returns the load transfer to come, > 0 in a left turn; finite. A yaw rate, speed or
    // steering angle that is missing or out of range is replaced by the measured force: in a steady turn they
    // agree.
    float update(const Vehicle& vehicle, const Inputs& inputs, const Measurement& measured,
                 const DemandedForce& demand);

    // The inputs of the weighted sum.
    const ForecastMatrix& lagged() const { return lagged_; }

 private:
    bool running_{false};
    ForecastMatrix lagged_{ForecastMatrix::Zero()};
};

}  // namespace rsi
