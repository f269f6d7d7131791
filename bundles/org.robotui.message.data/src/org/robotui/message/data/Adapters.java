package org.robotui.message.data;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.data.record.DynamicRecord;

/** All conversions by ROS type. A type that has none becomes a dynamic record. */
public final class Adapters {
  private final Map<String, Adapter<?, ?>> byType;

  /** The standard types. */
  public Adapters() {
    Map<String, Adapter<?, ?>> all = new HashMap<>();
    List.of(SensorAdapters.all(), CloudAdapters.all(), MotionAdapters.all(), NavigationAdapters.all(),
        StateAdapters.all(),
        MarkerAdapters.all(), PlanAdapters.all())
        .forEach(group -> group.forEach(a -> all.put(a.type(), a)));
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
}
