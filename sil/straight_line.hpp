// Straight line: a least-squares line through points.
#pragma once

namespace sil {

class StraightLine {
 public:
    void add(double x, double y) {
        count_ += 1.0;
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
    }

    // How many points it goes through.
    double count() const { return count_; }

    // y over x; 0 while no two points differ in x.
    double slope() const {
        const double variation = count_ * xx_ - x_ * x_;
        return variation > 0.0 ? (count_ * xy_ - x_ * y_) / variation : 0.0;
    }

    // Its y there; needs a point.
    double at(double x) const { return y_ / count_ + slope() * (x - x_ / count_); }

 private:
    double count_{0.0};
    double x_{0.0};
    double y_{0.0};
    double xx_{0.0};
    double xy_{0.0};
};

}  // namespace sil
