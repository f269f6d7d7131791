package org.robotui.message.data;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.data.Conflation;
import org.robotui.data.DataType;
import org.robotui.data.record.DynamicRecord;

/**
 * All conversions by type: types of ROS, common types of RoboFrame and of roblets, the schemas of Foxglove, which are
 * also a package of ROS, and messages of Gazebo. A type that has none becomes a dynamic record.
 */
public final class Adapters {
  private static final int MOST_EVENTS = 500;

  private final Map<String, Adapter<?, ?>> byType;

  /** The standard types. */
  public Adapters() {
    Map<String, Adapter<?, ?>> all = new HashMap<>();
    List.of(SensorAdapters.all(), CloudAdapters.all(), MotionAdapters.all(), NavigationAdapters.all(),
        StateAdapters.all(),
        MarkerAdapters.all(), PlanAdapters.all(), RoboframeAdapters.all(), RobletMessages.all())
        .forEach(group -> group.forEach(a -> all.put(a.type(), a)));
    FoxgloveAdapters.all().forEach(a -> List.of(FoxgloveAdapters.NAMES, FoxgloveAdapters.ROS_PACKAGE)
        .forEach(prefix -> all.put(prefix + a.type(), a.named(prefix + a.type()))));
    GazeboAdapters.all().forEach(a -> GazeboAdapters.PACKAGES
        .forEach(prefix -> all.put(prefix + a.type(), a.named(prefix + a.type()))));
    this.byType = Map.copyOf(all);
  }

  /**
   * The conversion of a type.
   *
   * @param type a ROS type of two parts, such as {@code sensor_msgs/LaserScan}
   * @return its own, or that into dynamic records
   */
  public Adapter<?, ?> of(String type) {
    Adapter<?, ?> known = byType.get(type);
    return known != null ? known : Adapter.ofDynamic(type, DynamicRecord.class, (m, names) -> new MessageRecord(m));
  }

  /**
   * The conversion of a type that no definition of ROS defines.
   *
   * @param type the robot's name of the type, such as {@code foxglove.LaserScan}
   * @return its own, where its messages are read by the names of their fields, or that into dynamic records
   */
  public Adapter<?, ?> ofFields(String type) {
    Adapter<?, ?> known = byType.get(type);
    return known != null && known.form() instanceof MessageForm.ByFields ? known
        : new Adapter<>(type, new MessageForm.ByFields(), DynamicRecord.class, (m, names) -> Optional.of(m), m -> 0);
  }

  /**
   * How many messages of a type are worth keeping until they are taken.
   *
   * @param type the robot's name of the type
   * @param form what its messages are read as
   * @return 1 where only the newest counts, so that nothing grows old; else so many that no short delay loses one
   */
  public int mostWaiting(String type, MessageForm<?> form) {
    Adapter<?, ?> adapter = form instanceof MessageForm.ByFields ? ofFields(type) : of(type);
    boolean sample = adapter.form().equals(form) && DataType.of(adapter.data()).conflation() == Conflation.SAMPLE;
    return sample ? 1 : MOST_EVENTS;
  }
}
