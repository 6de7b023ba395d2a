// Counted float: a float that counts the operations on it.
#pragma once

namespace budgets {

struct OperationCount {
    int additions{0};  // and subtractions
    int multiplications{0};
    int divisions{0};
    int total() const { return additions + multiplications + divisions; }
};

class CountedFloat {
 public:
    CountedFloat(float value, OperationCount& count) : value_{value}, count_{&count} {}

    float value() const { return value_; }

    friend CountedFloat operator+(CountedFloat a, CountedFloat b) {
        ++a.count_->additions;
        return {a.value_ + b.value_, *a.count_};
    }
    friend CountedFloat operator-(CountedFloat a, CountedFloat b) {
        ++a.count_->additions;
        return {a.value_ - b.value_, *a.count_};
    }
    friend CountedFloat operator*(CountedFloat a, CountedFloat b) {
        ++a.count_->multiplications;
        return {a.value_ * b.value_, *a.count_};
    }
    friend CountedFloat operator/(CountedFloat a, CountedFloat b) {
        ++a.count_->divisions;
        return {a.value_ / b.value_, *a.count_};
    }

 private:
    float value_;
    OperationCount* count_;
};

}  // namespace budgets
