package org.robotui.data.sensor;

import java.util.List;
import java.util.stream.Stream;
import org.robotui.data.Conflation;
import org.robotui.data.Delivery;
import org.robotui.data.FrameId;
import org.robotui.data.Framed;
import org.robotui.data.Keyed;
import org.robotui.data.Late;
import org.robotui.data.internal.Merge;

/**
 * Distances of several sensors, the newest per sensor frame.
 *
 * @param readings one per sensor
 */
@Delivery(conflation = Conflation.KEYED, late = Late.ALL_KEYS)
public record RangeReadings(List<RangeReading> readings) implements Keyed<RangeReadings>, Framed {
  /**
   * Copies the list.
   *
   * @param readings one per sensor
   */
  public RangeReadings {
    readings = List.copyOf(readings);
  }

  @Override
  public Stream<FrameId> frames() {
    return readings.stream().map(RangeReading::frame).filter(FrameId::isNamed);
  }

  @Override
  public RangeReadings over(RangeReadings older) {
    return new RangeReadings(Merge.byKey(older.readings, readings, RangeReading::frame));
  }

  @Override
  public int keys() {
    return readings.size();
  }

  @Override
  public RangeReadings last(int most) {
    return new RangeReadings(Merge.last(readings, most));
  }
}
