package org.robotui.message.data;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.BiFunction;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.array.Doubles;
import org.robotui.data.navigation.Odometry;
import org.robotui.data.navigation.PoseEstimate;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.record.FieldValue;
import org.robotui.data.sensor.Battery;
import org.robotui.data.sensor.GpsFix;
import org.robotui.data.sensor.Imu;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * What roblets say that there is a data type for, by the word that their beacons have for it. Numbers that have to be
 * there and are not make an {@link IllegalArgumentException}, which names them.
 */
public final class RobletMessages {
  /** How the types of such messages begin, before the word. */
  public static final String NAMES = "roblets.";

  private static final String BASE = "base_link";
  private static final String ODOM = "odom";
  private static final String MAP = "map";

  private RobletMessages() {}

  /** By their types. Messages name no frames: those are the usual ones. */
  static List<Adapter<?, ?>> all() {
    return List.of(adapter("gpsfix", GpsFix.class, (said, names) -> fix(said, names.frame(BASE))),
        adapter("heading", Imu.class, (said, names) -> heading(said, names.frame(BASE))),
        adapter("pose", PoseEstimate.class, (said, names) -> pose(said, names.frame(MAP))),
        adapter("odometry", Odometry.class, (said, names) -> odometry(said, names.frame(ODOM), names.frame(BASE))),
        adapter("battery", Battery.class, (said, names) -> battery(said)));
  }

  private static <D extends Data> Adapter<DynamicRecord, D> adapter(String word, Class<D> data,
      BiFunction<DynamicRecord, FrameNames, D> convert) {
    return new Adapter<>(NAMES + word, new MessageForm.ByFields(), data,
        (said, names) -> Optional.of(convert.apply(said, names)), said -> 0);
  }

  /**
   * Whether there is a data type for a word.
   *
   * @param word what a message is, as a beacon says it
   * @return true where there is
   */
  public static boolean isKnown(String word) {
    return all().stream().anyMatch(each -> each.type().equals(NAMES + word));
  }

  /**
   * A place on earth: degrees, metres above the ellipsoid.
   *
   * @param said {@code latitude}, {@code longitude}; perhaps {@code altitude}, {@code accuracy}, {@code fix}
   * @param base the frame of what is there
   * @return without a position where there is no fix
   */
  public static GpsFix fix(DynamicRecord said, FrameId base) {
    if (said.field("fix").filter(new FieldValue.Flag(false)::equals).isPresent()) {
      return new GpsFix(base, GpsFix.Quality.NO_FIX, Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    }
    return new GpsFix(base, GpsFix.Quality.FIX, Math.toRadians(needed(said, "latitude")),
        Math.toRadians(needed(said, "longitude")), number(said, "altitude").orElse(Double.NaN),
        number(said, "accuracy").orElse(Double.NaN));
  }

  /**
   * Where a bow points.
   *
   * @param said {@code heading}, degrees from north over east, as compasses say it; perhaps {@code rate}, how fast it
   * grows
   * @param base the frame of what turns
   * @return turned in the plane
   */
  public static Imu heading(DynamicRecord said, FrameId base) {
    Optional<Vector3> turning = number(said, "rate").isPresent()
        ? Optional.of(new Vector3(0, 0, -Math.toRadians(needed(said, "rate"))))
        : Optional.empty();
    return new Imu(base, Optional.of(Quaternion.fromYaw(Math.PI / 2 - Math.toRadians(needed(said, "heading")))),
        turning, Optional.empty());
  }

  /**
   * A place on the map.
   *
   * @param said {@code x}, {@code y}, {@code yaw} in metres and radians; perhaps {@code z}
   * @param map the frame of the map
   * @return the place
   */
  public static PoseEstimate pose(DynamicRecord said, FrameId map) {
    return new PoseEstimate(map, place(said), Doubles.EMPTY);
  }

  /**
   * A place since it began.
   *
   * @param said {@code x}, {@code y}, {@code yaw} in metres and radians; perhaps {@code vx}, {@code vy}, {@code wz} in
   * a second
   * @param odom the frame in which that is
   * @param base the frame of what moves
   * @return the place and how it changes
   */
  public static Odometry odometry(DynamicRecord said, FrameId odom, FrameId base) {
    return new Odometry(odom, base, place(said), Doubles.EMPTY,
        new Vector3(number(said, "vx").orElse(0), number(said, "vy").orElse(0), 0),
        new Vector3(0, 0, number(said, "wz").orElse(0)), Doubles.EMPTY);
  }

  /**
   * What a battery holds.
   *
   * @param said {@code voltage}, {@code current}, and {@code charge} from 0 to 1, as far as they are known
   * @return the battery
   */
  public static Battery battery(DynamicRecord said) {
    return new Battery(number(said, "voltage").orElse(Double.NaN), number(said, "current").orElse(Double.NaN),
        number(said, "charge").orElse(Double.NaN), Battery.Status.UNKNOWN);
  }

  private static RigidTransform place(DynamicRecord said) {
    return new RigidTransform(new Vector3(needed(said, "x"), needed(said, "y"), number(said, "z").orElse(0)),
        Quaternion.fromYaw(needed(said, "yaw")));
  }

  private static OptionalDouble number(DynamicRecord said, String name) {
    return said.number(new FieldPath(List.of(new FieldPath.Step.Field(name))));
  }

  private static double needed(DynamicRecord said, String name) {
    double value = number(said, name).orElse(Double.NaN);
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(said.schema() + " has no finite number '" + name + "'");
    }
    return value;
  }
}
