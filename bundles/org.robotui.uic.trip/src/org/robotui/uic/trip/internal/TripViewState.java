package org.robotui.uic.trip.internal;

import java.util.List;
import org.robotui.api.port.InputState;
import org.robotui.ui.Role;

/**
 * What there is to paint.
 *
 * @param input what the port has, or why it has nothing
 * @param trips one for each source
 * @param limit metres from which a trip is a warning
 */
record TripViewState(InputState input, List<TripMeter.Trip> trips, double limit) {

  Role role(TripMeter.Trip trip) {
    return trip.metres() > limit ? Role.WARNING : Role.TEXT;
  }
}
