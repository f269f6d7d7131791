package org.robotui.player.interfaces;

import org.robotui.player.layout.Empty;
import org.robotui.player.layout.Kind;

/** Inertial measurement units. The interface {@code imu}. */
public final class Imu {

  /** Data: state. */
  public static final Kind.Data<State> STATE = new Kind.Data<>("imu", "state", State.class);

  /** Data: calibrated. */
  public static final Kind.Data<Calibrated> CALIBRATED = new Kind.Data<>("imu", "calibrated", Calibrated.class);

  /** Data: quaternion. */
  public static final Kind.Data<Quaternion> QUATERNION = new Kind.Data<>("imu", "quaternion", Quaternion.class);

  /** Data: euler. */
  public static final Kind.Data<Euler> EULER = new Kind.Data<>("imu", "euler", Euler.class);

  /** Data: full state. */
  public static final Kind.Data<FullState> FULL_STATE = new Kind.Data<>("imu", "full_state", FullState.class);

  /** Request: set data type by {@link DataType}; the answer is empty. */
  public static final Kind.Request<DataType, Empty> SET_DATA_TYPE =
      new Kind.Request<>("imu", "set_data_type", DataType.class, Empty.class);

  /** Request: reset orientation by {@link Setting}; the answer is empty. */
  public static final Kind.Request<Setting, Empty> RESET_ORIENTATION =
      new Kind.Request<>("imu", "reset_orientation", Setting.class, Empty.class);

  /** Request: reset euler by {@link Orientation}; the answer is empty. */
  public static final Kind.Request<Orientation, Empty> RESET_EULER =
      new Kind.Request<>("imu", "reset_euler", Orientation.class, Empty.class);

  private Imu() {}

  /**
   * Where the unit is.
   *
   * @param pose integrated by the unit
   */
  public record State(Pose3d pose) {}

  /**
   * What the sensors measure.
   *
   * @param accelerationX forward, metres per second squared
   * @param accelerationY to the left, metres per second squared
   * @param accelerationZ up, metres per second squared
   * @param gyroX about x, radians per second
   * @param gyroY about y, radians per second
   * @param gyroZ about z, radians per second
   * @param magneticX in the device's unit
   * @param magneticY in the device's unit
   * @param magneticZ in the device's unit
   */
  public record Calibrated(
      float accelerationX, float accelerationY, float accelerationZ, float gyroX, float gyroY, float gyroZ,
      float magneticX, float magneticY,
      float magneticZ) {}

  /**
   * What the sensors measure, and the orientation of length 1.
   *
   * @param measured by the sensors
   * @param w the real part
   * @param x about x
   * @param y about y
   * @param z about z
   */
  public record Quaternion(Calibrated measured, float w, float x, float y, float z) {}

  /**
   * What the sensors measure, and the orientation.
   *
   * @param measured by the sensors
   * @param orientation of the unit
   */
  public record Euler(Calibrated measured, Angles orientation) {}

  /**
   * All about the unit's motion.
   *
   * @param pose integrated by the unit
   * @param velocity per second
   * @param acceleration per second and second
   */
  public record FullState(Pose3d pose, Pose3d velocity, Pose3d acceleration) {}

  /**
   * What it shall send.
   *
   * @param value 1 state, 2 calibrated, 3 quaternion, 4 euler, 5 full state
   */
  public record DataType(int value) {}

  /**
   * What the orientation shall be.
   *
   * @param orientation of which the angles count
   */
  public record Orientation(Pose3d orientation) {}
}
