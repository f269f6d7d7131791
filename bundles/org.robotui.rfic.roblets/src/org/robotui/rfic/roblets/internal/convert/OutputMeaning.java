package org.robotui.rfic.roblets.internal.convert;

import java.util.Optional;
import org.robotui.api.session.RobotFrames;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;
import org.robotui.roblets.tree.BodyElement;

/** What roblets say that the house has a data type for, by the word that their beacons have for it. */
public final class OutputMeaning {
  private OutputMeaning() {}

  /** Degrees, metres above the ellipsoid; without a position where there is no fix. */
  public static GpsFix fix(BodyElement said, RobotFrames frames) {
    if (said.attribute("fix").filter("false"::equals).isPresent()) {
      return new GpsFix(frames.base(), GpsFix.Quality.NO_FIX, Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    }
    return new GpsFix(frames.base(), GpsFix.Quality.FIX, Math.toRadians(said.needed("latitude")),
        Math.toRadians(said.needed("longitude")), said.number("altitude").orElse(Double.NaN),
        said.number("accuracy").orElse(Double.NaN));
  }

  /** Degrees from north over east, as compasses say it, and how fast it grows. */
  public static Imu heading(BodyElement said, RobotFrames frames) {
    Optional<Vector3> turning = said.number("rate").isPresent()
        ? Optional.of(new Vector3(0, 0, -Math.toRadians(said.needed("rate"))))
        : Optional.empty();
    return new Imu(frames.base(),
        Optional.of(Quaternion.fromYaw(Math.PI / 2 - Math.toRadians(said.needed("heading")))), turning,
        Optional.empty());
  }

  private static RigidTransform place(BodyElement said) {
    return new RigidTransform(new Vector3(said.needed("x"), said.needed("y"), said.number("z").orElse(0)),
        Quaternion.fromYaw(said.needed("yaw")));
  }

  /** Metres and radians on the map. */
  public static PoseEstimate pose(BodyElement said, RobotFrames frames) {
    return new PoseEstimate(frames.map(), place(said), Doubles.EMPTY);
  }

  /** Metres and radians since it began, and in a second. */
  public static Odometry odometry(BodyElement said, RobotFrames frames) {
    return new Odometry(frames.odom(), frames.base(), place(said), Doubles.EMPTY,
        new Vector3(said.number("vx").orElse(0), said.number("vy").orElse(0), 0),
        new Vector3(0, 0, said.number("wz").orElse(0)), Doubles.EMPTY);
  }

  /** Volts, amperes, and 0 to 1. */
  public static Battery battery(BodyElement said) {
    return new Battery(said.number("voltage").orElse(Double.NaN), said.number("current").orElse(Double.NaN),
        said.number("charge").orElse(Double.NaN), Battery.Status.UNKNOWN);
  }
}
