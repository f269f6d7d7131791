package org.robotui.rfic.ros.internal.convert;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.robotui.data.record.DynamicRecord;
import org.robotui.message.MessageRegistry;
import org.robotui.message.RawCodec;

/** All conversions by ROS type. A type that has none becomes a dynamic record. */
public final class Adapters {
  private final Map<String, Adapter<?, ?>> byType;
  private final RecordDecoder records;

  /**
   * The standard types.
   *
   * @param registry knows message definitions
   */
  public Adapters(MessageRegistry registry) {
    this.records = new RecordDecoder(registry);
    Map<String, Adapter<?, ?>> all = new HashMap<>();
    List.of(SensorAdapters.all(), CloudAdapters.all(), MotionAdapters.all(), NavigationAdapters.all(),
        StateAdapters.all(),
        MarkerAdapters.all(registry), PlanAdapters.all(records))
        .forEach(group -> group.forEach(a -> all.put(a.type(), a)));
    this.byType = Map.copyOf(all);
  }

  /**
   * The conversion of a type.
   *
   * @param type a ROS type
   * @return its own, or that into dynamic records
   */
  public Adapter<?, ?> of(String type) {
    Adapter<?, ?> known = byType.get(type);
    return known != null ? known
        : Adapter.of(type, RawCodec::new, DynamicRecord.class, (m, names) -> records.decode(m), m -> 0);
  }

  /**
   * Reads messages of any type as dynamic records.
   *
   * @return the decoder
   */
  public RecordDecoder records() {
    return records;
  }
}
