package org.robotui.rfic.roblets.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.api.Rfic;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.CallHandler;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.data.Data;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldPath;
import org.robotui.data.sensor.Imu;
import org.robotui.data.status.BodyState;
import org.robotui.data.status.Diagnostics;
import org.robotui.roblets.brain.Brain;
import org.robotui.roblets.brain.BrainOptions;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyForm;
import org.robotui.roblets.wire.RobletForm;
import org.robotui.testkit.FakeRficContext;
import org.robotui.testkit.rfic.Peer;

/** Roblets that come and go under a robot interface: ports, the whole body, services, and what is browsed. */
@Timeout(120)
class RobletsComeAndGoTest {
  private static final RobletForm COMPASS = new RobletForm("compass", 10,
      List.of(new BodyForm("heading", "heading", List.of()), new BodyForm("state", "", List.of())),
      List.of(new BodyForm("trim", "", List.of(new BodyForm.Field("offset", "number", "deg"))),
          new BodyForm("turn", "velocity", List.of())),
      List.of("gps"));

  private final FakeRficContext context = new FakeRficContext();
  private final List<BodyElement> told = new CopyOnWriteArrayList<>();
  private final Brain brain = new Brain(BrainOptions.loopback(Peer.THREADS, 0, "boat"));
  private final Rfic rfic = RobletsSessions.rfic(context, RobletsPeer.settings(brain.port()));
  private Optional<BareRoblet> compass = Optional.empty();

  RobletsComeAndGoTest() throws IOException {
    rfic.start();
    compass = Optional.of(new BareRoblet(COMPASS, brain.port(), told::add));
  }

  @AfterEach
  void end() {
    rfic.close();
    compass.ifPresent(BareRoblet::close);
    brain.close();
  }

  private void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + Duration.ofSeconds(60).toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() - end < 0,
          () -> what + "; " + context.links.peekLast() + " " + context.streams.keySet() + " " + context.complaints);
      try {
        say();
        Thread.sleep(20);
      } catch (IOException | InterruptedException e) {
        throw new AssertionError(e);
      }
    }
  }

  private void say() throws IOException {
    if (compass.isPresent()) {
      compass.get().say(BodyElement.of("heading").with("heading", 90).with("rate", 10), 0);
      compass.get().say(BodyElement.of("state").with("well", true).with(List.of(
          BodyElement.of("coil").with("ohm", 12), BodyElement.of("coil").with("ohm", 13))), 0);
    }
  }

  private <D extends Data> D next(String port, Class<D> type) {
    await(port + " is offered", () -> context.streams.containsKey(port));
    context.demand(port, true);
    await("one of " + port, () -> !context.published.getOrDefault(port, new ArrayDeque<>()).isEmpty());
    return type.cast(context.published.get(port).peekLast().value());
  }

  @Test
  void messages_become_data_and_records() {
    Imu heading = next("compass/heading", Imu.class);
    assertEquals(0, heading.orientation().orElseThrow().yaw(), 1e-9, "east is along x");
    assertEquals(-Math.toRadians(10), heading.angularVelocity().orElseThrow().z(), 1e-9);
    DynamicRecord state = next("compass/state", DynamicRecord.class);
    assertEquals(List.of("well", "coil"), state.fields());
    assertEquals(13, state.number(FieldPath.parse("coil[1].ohm")).orElseThrow());
  }

  @Test
  void the_body_says_how_its_parts_do() {
    next("body", BodyState.class);
    await("the compass is there, is well and says something", () -> part()
        .filter(p -> p.says().size() == 2 && p.level() == Diagnostics.Level.OK).isPresent());
    assertEquals("heading", part().orElseThrow().says().getFirst().name());
    compass.ifPresent(BareRoblet::close);
    compass = Optional.empty();
    await("that it is silent is told", () -> part().filter(p -> p.state().equals("silent")).isPresent());
    assertEquals(Diagnostics.Level.STALE, part().orElseThrow().level());
    await("its ports say so", () -> context.complaints.get("compass/heading").stream()
        .anyMatch(c -> c.contains("the roblet compass is silent")));
  }

  private Optional<BodyState.Part> part() {
    return Optional.ofNullable(context.published.get("body")).map(all -> all.peekLast())
        .map(last -> (BodyState) last.value()).flatMap(body -> body.parts().stream().findFirst());
  }

  @SuppressWarnings("unchecked")
  private ServiceReply ask(String service, Map<String, Object> arguments) throws CallException, InterruptedException {
    ServiceRequest request = new ServiceRequest(service, arguments);
    return ((CallHandler<ServiceRequest, ServiceReply>) context.handlers.get("services"))
        .handle(new CallHandler.Invocation<>() {
          @Override
          public ServiceRequest request() {
            return request;
          }

          @Override
          public long deadlineNanos() {
            return System.nanoTime() + Duration.ofSeconds(20).toNanos();
          }

          @Override
          public void progress(double fraction, String message) {
            // nobody looks
          }

          @Override
          public void feedback(DynamicRecord record) {
            // nobody looks
          }
        });
  }

  @Test
  void services_say_messages_but_nothing_drives() throws CallException, InterruptedException {
    await("the compass is known", () -> context.commands.containsKey("compass/turn"));
    await("it is told", () -> {
      try {
        ask("compass/trim", Map.of("offset", 2.5));
      } catch (CallException e) {
        assertTrue(e.getMessage().contains("silent"), e::getMessage); // for a moment, on a loaded machine
      } catch (InterruptedException e) {
        throw new AssertionError(e);
      }
      return told.contains(BodyElement.of("trim").with("offset", 2.5));
    });
    for (String[] wrong : new String[][]{{"compass/turn", "drives"}, {"gps/trim", "no roblet"}}) {
      String said = assertThrows(CallException.class, () -> ask(wrong[0], Map.of())).getMessage();
      assertTrue(said.contains(wrong[1]), said);
    }
    await("what it does not have is named", () -> {
      String said = assertThrows(CallException.class, () -> ask("compass/trim", Map.of("x", 1))).getMessage();
      assertTrue(said.contains("'x'") && said.contains("offset") || said.contains("silent"), said);
      return said.contains("'x'");
    });
  }

  @Test
  void what_the_brain_knows_is_browsed() throws CallException {
    await("the compass is known", () -> context.commands.containsKey("compass/turn"));
    Browser browser = context.browsers.get("graph");
    assertEquals(List.of("compass"), names(browser, Browser.Kind.NODE));
    assertEquals(List.of("compass/heading", "compass/state"), names(browser, Browser.Kind.TOPIC));
    assertEquals(List.of("compass/trim", "compass/turn"), names(browser, Browser.Kind.SERVICE));
    assertEquals("offset", trim(browser).shape().orElseThrow().fields().getFirst().name());
    await("it is said to run", () -> "running".equals(trim(browser).facts().get("state")));
    assertTrue(browser.links().contains(new Browser.Link("compass", "compass to gps", true)));
  }

  private static Browser.Description trim(Browser browser) {
    try {
      return browser.describe(browser.list(Browser.Kind.SERVICE).getFirst());
    } catch (CallException e) {
      throw new AssertionError(e);
    }
  }

  private static List<String> names(Browser browser, Browser.Kind kind) throws CallException {
    return browser.list(kind).stream().map(Browser.Item::name).toList();
  }
}
