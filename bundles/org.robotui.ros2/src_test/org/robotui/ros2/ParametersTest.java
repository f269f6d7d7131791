package org.robotui.ros2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.net.call.Outcome;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor;
import org.robotui.ros2.parameter.Ros2ParameterDescriptor.DoubleRange;
import org.robotui.ros2.parameter.Ros2ParameterEvent;
import org.robotui.ros2.parameter.Ros2ParameterServer;
import org.robotui.ros2.parameter.Ros2ParameterValue;
import org.robotui.ros2.parameter.Ros2ParameterValue.OfDouble;
import org.robotui.ros2.parameter.Ros2ParameterValue.OfText;
import org.robotui.ros2.parameter.Ros2ParameterValue.Unset;
import org.robotui.ros2.parameter.Ros2Parameters;

/** Parameters of one node, asked for and set by another. */
class ParametersTest {

  private final FakeDomain domain = new FakeDomain();
  private final Ros2ParameterServer server = Ros2ParameterServer.open(domain.context().node("base"));
  private final Ros2Node here = domain.context().node("here");
  private final Ros2Parameters parameters = Ros2Parameters.open(here, Ros2Name.of("/base"), Duration.ofSeconds(5));

  ParametersTest() {
    server.declare(Ros2ParameterDescriptor.of("speed.max", new OfDouble(1), "m/s").within(new DoubleRange(0, 2, 0.5)),
        new OfDouble(1), value -> Optional.empty());
    server.declare(Ros2ParameterDescriptor.of("name", new OfText(""), "what it is called"), new OfText("natalie"),
        value -> value.equals(new OfText("")) ? Optional.of("it must be called something") : Optional.empty());
  }

  @AfterEach
  void close() {
    domain.close();
  }

  @Test
  void namesValuesAndDescriptionsAreRead() {
    assertEquals(new Outcome.Done<>(List.of("speed.max", "name")), parameters.names());
    assertEquals(new Outcome.Done<>(Map.of("name", new OfText("natalie"), "none", new Unset())),
        parameters.get(List.of("name", "none")));
    Ros2ParameterDescriptor speed =
        parameters.describe(List.of("speed.max")).toOptional().orElseThrow().get("speed.max");
    assertEquals(Optional.of(new DoubleRange(0, 2, 0.5)), speed.doubles());
    assertEquals("m/s", speed.description());
    assertInstanceOf(Outcome.Refused.class, parameters.describe(List.of("none")));
  }

  @Test
  void aValueIsSetAndAllHearOfIt() throws Exception {
    BlockingQueue<Ros2ParameterEvent> events = new LinkedBlockingQueue<>();
    Ros2Parameters.follow(here, events::add);
    BlockingQueue<Map<String, Ros2ParameterValue>> set = new LinkedBlockingQueue<>();
    server.onSet(set::add);
    assertEquals(new Outcome.Done<>(true), parameters.set("speed.max", new OfDouble(1.5)));
    assertEquals(new OfDouble(1.5), server.value("speed.max"));
    assertEquals(Map.of("speed.max", new OfDouble(1.5)), events.poll(5, TimeUnit.SECONDS).values());
    assertEquals(List.of(Map.of("speed.max", new OfDouble(1.5))), List.copyOf(set));
  }

  @Test
  void whatAParameterMayNotBeIsRefusedWithTheReason() {
    assertEquals("/base: parameter 'speed.max' is from 0.0 to 2.0 in its steps, which 1.7 is not",
        parameters.set("speed.max", new OfDouble(1.7)).reason());
    assertEquals("/base: it must be called something", parameters.set("name", new OfText("")).reason());
    assertEquals("/base: parameter 'name' has type 4, not 3", parameters.set("name", new OfDouble(1)).reason());
    assertEquals("/base: there is no parameter 'none'", parameters.set("none", new OfDouble(1)).reason());
  }

  @Test
  void allAreSetOrNone() {
    Outcome<Boolean> outcome =
        parameters.setAll(Map.of("speed.max", new OfDouble(2), "name", (Ros2ParameterValue) new OfText("")));
    assertInstanceOf(Outcome.Refused.class, outcome);
    assertEquals(new OfDouble(1), server.value("speed.max"));
  }

  @Test
  void aNodeThatIsNotThereIsSaidSo() {
    Ros2Parameters none = Ros2Parameters.open(here, Ros2Name.of("/none"), Duration.ofMillis(20));
    assertTrue(none.names().reason().startsWith("service /none/list_parameters has no server"),
        none.names().reason());
  }
}
