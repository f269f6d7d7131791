package org.robotui.rfic.yarp.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Supplier;
import org.robotui.api.session.PlaceCommands;
import org.robotui.data.geometry.Pose;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;
import org.robotui.rfic.yarp.internal.convert.NavigationForms;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.port.PortCall;

/**
 * Tells places by questions.
 *
 * @param go by which function
 * @param stop by which function what is on its way is stopped; none where nothing moves
 * @param map tells on which map the robot is, which may block
 */
record PlaceSender<C extends Pose>(Wires wires, Supplier<HostPort> where, String go, Optional<String> stop,
    Supplier<Optional<String>> map) implements PlaceCommands.Telling<C> {
  private static final Duration PATIENCE = Duration.ofMillis(1500);

  @Override
  public void tell(C place) throws IOException {
    String name = map.get().orElseThrow(
        () -> new IOException("it needs the name of the map on which the robot is, which nothing tells"));
    ask(NavigationForms.question(go, NavigationForms.location(name, place.pose())));
  }

  @Override
  public void halt() throws IOException {
    if (stop.isPresent()) {
      ask(NavigationForms.question(stop.get()));
    }
  }

  private void ask(Bottle question) throws IOException {
    try (PortCall call = PortCall.connect(where.get(), wires.own() + "/rpc", wires.options())) {
      Outcome<Bottle> outcome = call.ask(question, PATIENCE);
      Bottle answer = outcome.toOptional().orElseThrow(() -> new IOException(outcome.reason()));
      if (!NavigationForms.isDone(answer)) {
        throw new IOException("it answered " + answer);
      }
    }
  }
}
