package org.robotui.rfic.recording.internal.time;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.robotui.api.replay.Timeline.LaneId;

/**
 * A wish for the next or the former message.
 *
 * @param forward whether for the next
 * @param lane of one topic; of any where there is none
 */
record StepWish(boolean forward, Optional<LaneId> lane) {

  /** The time of that message on the timeline. Reads the files. */
  Optional<Long> nearest(List<Seat> seats, long at) {
    Comparator<Long> order = Comparator.naturalOrder();
    return seats.stream().filter(seat -> lane.isEmpty() || lane.get().track().equals(seat.track().id()))
        .flatMap(seat -> in(seat, at).stream()).min(forward ? order : order.reversed());
  }

  private Optional<Long> in(Seat seat, long at) {
    OptionalLong found = seat.track().neighbour(forward, seat.toFile(at), lane.map(LaneId::topic));
    return found.isPresent() ? Optional.of(seat.toTimeline(found.getAsLong())) : Optional.empty();
  }
}
