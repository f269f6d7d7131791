package org.robotui.core.internal.port;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.Input;
import org.robotui.api.port.InputState;
import org.robotui.api.port.Intake;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.core.internal.support.ManualClock;
import org.robotui.core.internal.support.Samples;
import org.robotui.core.internal.time.Ageing;
import org.robotui.data.array.Bytes;
import org.robotui.data.sensor.LaserScan;

/** A view that chooses what it takes. */
class ChosenInputTest {
  private final ManualClock clock = new ManualClock();
  private final Link link = new Link(clock, () -> {});
  private final List<String> demand = new ArrayList<>();
  private final StreamSource<LaserScan> front = source("front");
  private final StreamSource<LaserScan> rear = source("rear");
  private final InputEnd<LaserScan> input = new InputEnd<>(Intake.CHOSEN, clock);

  private StreamSource<LaserScan> source(String name) {
    StreamPort<LaserScan> port = new StreamPort<>(name, LaserScan.class, Arity.MANY, "");
    return new StreamSource<>(new SourceId("base", name), port, link, clock, Ageing.by(clock),
        wanted -> demand.add((wanted ? "+" : "-") + name), Runnable::run, o -> {});
  }

  private void publish(StreamSource<LaserScan> source, int count, int bytes) {
    Bytes raw = Bytes.wrap(new byte[bytes], 0, bytes);
    for (int i = 0; i < count; i++) {
      source.publish(Samples.scan(i), Optional.empty(), clock.nanos(),
          Optional.of(new RawMessage("scan", "none", raw, RawMessage.Reader.NONE)));
    }
  }

  private List<Envelope<LaserScan>> drained() {
    List<Envelope<LaserScan>> all = new ArrayList<>();
    input.drain(all::add);
    return all;
  }

  @Test
  void nothingIsAskedForBeforeItIsChosen() {
    input.connect(List.of(front, rear), "every port of type LaserScan");
    assertEquals(List.of(), demand);
    assertEquals(List.of(), input.sources());
    assertEquals(
        List.of(new Input.Candidate(front.id(), "LaserScan"), new Input.Candidate(rear.id(), "LaserScan")),
        input.candidates());
    assertTrue(assertInstanceOf(InputState.Unconnected.class, input.state()).explanation().contains("2 streams fit"));
    input.choose(Set.of(rear.id()));
    assertEquals(List.of("+rear"), demand);
    assertEquals(List.of(rear.id()), input.sources());
    input.choose(Set.of(front.id()));
    assertEquals(List.of("+rear", "+front", "-rear"), demand);
  }

  @Test
  void everyValueOfAChosenSourceIsKeptAndOneChosenOnLosesNothing() {
    link.report(new LinkState.Connected("robot"));
    input.connect(List.of(front, rear), "");
    input.choose(Set.of(front.id()));
    publish(front, 5, 10);
    input.choose(Set.of(front.id(), rear.id()));
    publish(rear, 2, 10);
    assertEquals(7, drained().size());
    assertInstanceOf(InputState.Live.class, input.state(front.id()));
  }

  @Test
  void whatIsChosenBeforeItIsThereIsTakenWhenItComes() {
    input.choose(Set.of(rear.id()));
    input.connect(List.of(front), "");
    assertEquals(List.of(), demand);
    input.connect(List.of(front, rear), "");
    assertEquals(List.of("+rear"), demand);
  }

  @Test
  void largeMessagesFillTheQueueBySize() {
    input.connect(List.of(front), "");
    input.choose(Set.of(front.id()));
    int megabyte = 1 << 20;
    publish(front, 200, megabyte);
    assertEquals(EventMailbox.BYTES / megabyte, drained().size());
    assertEquals(200 - EventMailbox.BYTES / megabyte, input.dropped());
    publish(front, 1, (int) EventMailbox.BYTES + 1);
    assertEquals(1, drained().size(), "one always fits");
  }

  @Test
  void onlyPortsDeclaredSoCanChoose() {
    InputEnd<LaserScan> other = new InputEnd<>(Intake.MATCHED, clock);
    assertThrows(IllegalStateException.class, () -> other.choose(Set.of()));
  }
}
