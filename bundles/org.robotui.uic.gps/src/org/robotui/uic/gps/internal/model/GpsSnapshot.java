package org.robotui.uic.gps.internal.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.port.InputState;
import org.robotui.entity.gps.LocalPlane;

/**
 * What the canvas paints besides the layers.
 *
 * @param state of the inputs as a whole
 * @param plane on which all lies; none before there is an origin
 * @param receivers those that have sent something, in a stable order
 */
public record GpsSnapshot(InputState state, Optional<LocalPlane> plane, List<Receiver> receivers) {
  /** Before the first tick. */
  public static final GpsSnapshot NONE = new GpsSnapshot(
      new InputState.Waiting("The view has not looked for positions yet."), Optional.empty(), List.of());

  /** The receiver that is followed. */
  public Optional<Receiver> followed(String id) {
    return receivers.stream().filter(r -> r.id().toString().equals(id)).findFirst()
        .or(() -> receivers.stream().findFirst());
  }

  /** Whether there are receivers, and none of them knows where it is. */
  public boolean withoutFix() {
    return !receivers.isEmpty() && receivers.stream().noneMatch(Receiver::fixed);
  }
}
