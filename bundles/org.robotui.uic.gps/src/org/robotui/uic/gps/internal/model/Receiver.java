package org.robotui.uic.gps.internal.model;

import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.api.port.SourceId;
import org.robotui.data.sensor.GpsFix;
import org.robotui.entity.gps.GeoPoint;
import org.robotui.entity.gps.LocalPlane;

/**
 * A receiver at one moment.
 *
 * @param id where its fixes come from
 * @param name as users read it
 * @param trace which colour of the theme's traces
 * @param fix the newest
 * @param place the newest that was known
 * @param at that place on the plane, where it is in reach
 * @param state of its source
 */
public record Receiver(
    SourceId id,
    String name,
    int trace,
    GpsFix fix,
    Optional<GeoPoint> place,
    Optional<LocalPlane.Point> at,
    InputState state) {
  /** Whether it knows where it is. */
  public boolean fixed() {
    return GeoPoint.of(fix).isPresent();
  }
}
