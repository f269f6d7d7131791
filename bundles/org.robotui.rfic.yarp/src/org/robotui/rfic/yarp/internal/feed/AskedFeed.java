package org.robotui.rfic.yarp.internal.feed;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import org.robotui.api.session.AskedStream;
import org.robotui.data.Data;
import org.robotui.net.call.Outcome;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.port.PortCall;

/**
 * A port that is asked.
 *
 * @param <D> what is made of answers
 */
record AskedFeed<D extends Data>(Wires wires, PortCall call, Making<D> making) implements AskedStream.Source<D> {
  private static final Duration PATIENCE = Duration.ofMillis(1500);

  /**
   * Asks and makes data of the answer; nothing where there is nothing to say.
   *
   * @param <D> the data
   */
  interface Making<D> {
    Optional<D> ask(Questions questions) throws IOException;
  }

  /** Asks the port; an {@link IOException} says why there is no answer. */
  interface Questions {
    Bottle ask(Bottle question) throws IOException;
  }

  @Override
  public Optional<D> ask() throws IOException {
    return making.ask(this::answer);
  }

  private Bottle answer(Bottle question) throws IOException {
    Outcome<Bottle> outcome = call.ask(question, PATIENCE);
    Bottle answer = outcome.toOptional().orElseThrow(() -> new IOException(outcome.reason()));
    wires.pulse().answered(System.nanoTime());
    return answer;
  }

  @Override
  public void close() {
    call.close();
  }
}
