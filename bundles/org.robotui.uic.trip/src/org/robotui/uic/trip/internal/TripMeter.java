package org.robotui.uic.trip.internal;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.robotui.api.port.SourceId;
import org.robotui.geometry.Vector3;

/** How far each source of odometry has gone. For one thread. */
final class TripMeter {

  private final Map<SourceId, Trip> trips = new LinkedHashMap<>();

  /**
   * A trip.
   *
   * @param source who says where it is
   * @param at where it was last
   * @param metres how far it has gone
   */
  record Trip(SourceId source, Vector3 at, double metres) {

    Trip to(Vector3 next) {
      return new Trip(source, next, metres + next.minus(at).norm());
    }
  }

  void add(SourceId source, Vector3 at) {
    trips.compute(source, (id, trip) -> trip == null ? new Trip(id, at, 0) : trip.to(at));
  }

  void reset() {
    trips.replaceAll((source, trip) -> new Trip(source, trip.at(), 0));
  }

  List<Trip> trips() {
    return List.copyOf(trips.values());
  }
}
