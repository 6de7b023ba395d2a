"""The project's own frames by a mapping, as if they were foreign."""

import support

OWN_DBC = support.PROJECT / "can_dbc/rollover_warning.dbc"
OWN_MAPPING = "".join(f"[{quantity}]\nsignal = \"{signal}\"\n" for quantity, signal in (
    ("lateral_acceleration", "Imu.LateralAcceleration"),
    ("roll_rate", "Imu.RollRate"),
    ("vertical_acceleration", "Imu.VerticalAcceleration"),
    ("roll_angle", "RollAngle.RollAngle"),
    ("bank_angle", "RollAngle.BankAngle"),
    ("speed", "VehicleMotion.Speed"),
    ("yaw_rate", "VehicleMotion.YawRate"),
    ("steering_wheel_angle", "VehicleMotion.SteeringWheelAngle"),
))
