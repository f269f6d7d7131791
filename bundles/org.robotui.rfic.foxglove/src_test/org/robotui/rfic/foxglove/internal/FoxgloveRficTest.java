package org.robotui.rfic.foxglove.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.rfic.foxglove.internal.FoxgloveCase.await;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.Rfic;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.data.ClockKind;
import org.robotui.data.joint.RobotDescription;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;
import org.robotui.testkit.FakeRficContext;

class FoxgloveRficTest {
  private final FakeRficContext context = new FakeRficContext();
  private Optional<FoxgloveServer> opened = Optional.empty();
  private Optional<Rfic> begun = Optional.empty();

  private FoxgloveServer serve(String... capabilities) throws IOException {
    FoxgloveServer server = new FoxgloveServer(List.of(capabilities), List.of("json"));
    opened = Optional.of(server);
    return server;
  }

  private void begin(Map<String, Object> more) {
    Map<String, Object> settings = new HashMap<>(more);
    settings.put("url", "ws://127.0.0.1:" + opened.orElseThrow().port());
    Rfic rfic = FoxgloveCase.rfic(context, settings);
    begun = Optional.of(rfic);
    rfic.start();
    await(() -> Optional.ofNullable(context.links.peekLast()).filter(s -> s instanceof LinkState.Connected
        || s instanceof LinkState.Degraded).isPresent());
  }

  @AfterEach
  void end() {
    begun.ifPresent(Rfic::close);
    opened.ifPresent(FoxgloveServer::close);
  }

  private static ByteBuffer json(String text) {
    return ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
  }

  private void want(String port) {
    await(() -> context.streams.containsKey(port));
    context.demand(port, true);
  }

  private double last(String port, String field) {
    DynamicRecord record = (DynamicRecord) context.published.get(port).getLast().value();
    return ((FieldValue.Num) record.field(field).orElseThrow()).value();
  }

  @Test
  void anUnknownEncodingIsShownWithItsReasonAndOnlyThere() throws IOException, CallException {
    FoxgloveServer server = serve();
    server.channel(1, "/odd", "msgpack", "Odd", "", "");
    server.channel(2, "battery", "json", "", "", "");
    begin(Map.of());
    want("battery");
    await(() -> server.listeners(2) == 1);
    server.publish(2, json("{\"percent\":7}"));
    await(() -> !context.published.get("battery").isEmpty());
    assertEquals(7, last("battery", "percent"));
    want("odd");
    await(() -> context.complaints.get("odd").stream().anyMatch(reason -> reason.contains("msgpack")));
    assertEquals(0, server.listeners(1), "what nobody can read is not asked for");
    Browser browser = context.browsers.get("graph");
    Browser.Item odd = browser.list(Browser.Kind.TOPIC).stream().filter(i -> i.name().equals("/odd")).findFirst()
        .orElseThrow();
    assertTrue(browser.describe(odd).facts().get("definition").contains("msgpack"));
  }

  @Test
  void whatTheRobotIsMadeOfComesByItsTopic() throws IOException {
    FoxgloveServer server = serve();
    server.channel(3, "/robot_description", "json", "std_msgs/String", "", "");
    begin(Map.of());
    await(() -> server.listeners(3) == 1);
    server.publish(3, json("{\"data\":\"<robot name='keira'/>\"}"));
    await(() -> context.published.containsKey("robot_description")
        && !context.published.get("robot_description").isEmpty());
    RobotDescription made = (RobotDescription) context.published.get("robot_description").getLast().value();
    assertEquals("<robot name='keira'/>", made.urdf());
    server.withdraw(3);
    await(() -> !context.streams.containsKey("robot_description"));
  }

  @Test
  void aChannelThatComesAgainIsTakenUpAgain() throws IOException {
    FoxgloveServer server = serve();
    server.channel(1, "/a", "json", "A", "", "");
    begin(Map.of());
    want("a");
    await(() -> server.listeners(1) == 1);
    server.withdraw(1);
    server.channel(7, "/a", "json", "A", "", "");
    await(() -> server.listeners(7) == 1 && server.listeners(1) == 0);
    server.publish(7, json("{\"x\":1}"));
    await(() -> !context.published.get("a").isEmpty());
  }

  @Test
  void aViewThatIsSlowGetsTheNewestAndNoOther() throws IOException {
    FoxgloveServer server = serve();
    server.channel(1, "/a", "json", "A", "", "");
    begin(Map.of());
    want("a");
    await(() -> server.listeners(1) == 1);
    String padding = "x".repeat(500_000);
    for (int i = 0; i < 300; i++) {
      server.publish(1, json("{\"number\":" + i + ",\"padding\":\"" + padding + "\"}"));
    }
    await(() -> !context.published.get("a").isEmpty() && last("a", "number") == 299);
    assertTrue(context.published.get("a").size() <= 300);
    assertTrue(context.complaints.get("a").isEmpty(), "what gave way to a newer one is not lost");
  }

  @Test
  void transformsOfAnyNameBecomeFrames() throws IOException {
    FoxgloveServer server = serve();
    server.channel(1, "moving frames", "json", "foxglove.FrameTransform", "", "");
    begin(Map.of());
    want("moving frames");
    await(() -> server.listeners(1) == 1);
    String transform = "{\"timestamp\":{\"sec\":5,\"nsec\":0},\"parent_frame_id\":\"map\",\"child_frame_id\":"
        + "\"base\",\"translation\":{\"x\":1},\"rotation\":{\"w\":1}}";
    await(() -> {
      server.publish(1, json(transform)); // the two who want it do not begin at once
      return !context.transforms.isEmpty() && !context.published.get("moving frames").isEmpty();
    });
    assertEquals(1, context.transforms.getFirst().parentFromChild().translation().x());
  }

  @Test
  void theTimeOfTheServerIsTheTimeOfTheRobot() throws IOException {
    FoxgloveServer server = serve("time");
    server.channel(1, "/log", "json", "foxglove.Log", "", "");
    begin(Map.of());
    want("log");
    await(() -> server.listeners(1) == 1);
    server.tell(ByteBuffer.allocate(9).order(ByteOrder.LITTLE_ENDIAN).put((byte) 2).putLong(42).array());
    await(() -> context.simulated.contains(42L));
    server.publish(1, json("{\"timestamp\":{\"sec\":0,\"nsec\":40},\"level\":3,\"message\":\"m\",\"name\":\"n\"}"));
    await(() -> !context.published.get("log").isEmpty());
    assertEquals(ClockKind.SIMULATED, context.published.get("log").getFirst().stamp().orElseThrow().clock());
  }

  @Test
  void whatTheServerTellsItsUsersIsInTheLog() throws IOException {
    FoxgloveServer server = serve();
    begin(Map.of());
    server.tell(Map.of("op", "status", "level", 1, "message", "too much"));
    await(() -> !context.published.get("server_status").isEmpty());
    LogEntry said = (LogEntry) context.published.get("server_status").getFirst().value();
    assertEquals(List.of(Severity.WARNING, "too much"), List.of(said.severity(), said.message()));
  }

  @Test
  void whatTheServerLacksIsSaid() throws IOException {
    serve();
    begin(Map.of("velocity", List.of("cmd_vel")));
    assertTrue(context.links.getLast().reason().contains("clientPublish"), context.links.getLast().reason());
    Browser browser = context.browsers.get("graph");
    assertThrows(CallException.class, browser::links);
    assertThrows(CallException.class, () -> browser.list(Browser.Kind.PARAMETER));
  }

  @Test
  void parametersAreReadSetAndFollowed() throws IOException, CallException {
    FoxgloveServer server = serve("parameters", "parametersSubscribe");
    server.parameters.putAll(Map.of("speed", 0.5, "name", "r", "list", List.of(1, 2)));
    begin(Map.of());
    Browser browser = context.browsers.get("graph");
    assertEquals(List.of("list", "name", "speed"),
        browser.list(Browser.Kind.PARAMETER).stream().map(Browser.Item::name).toList());
    assertEquals(Optional.of(List.of(1L, 2L)), browser.parameter("list"));
    browser.setParameter("speed", 0.75);
    assertEquals(Optional.of(0.75), browser.parameter("speed"));
    await(() -> server.heard.contains("subscribeParameterUpdates"));
    long asked = server.heard.stream().filter("getParameters"::equals).count();
    server.tell(Map.of("op", "parameterValues", "parameters", List.of(Map.of("name", "speed", "value", 2))));
    await(() -> is(browser, "speed", 2L));
    assertEquals(asked, server.heard.stream().filter("getParameters"::equals).count(), "the change came by itself");
    assertFalse(browser.parameter("none").isPresent());
  }

  private static boolean is(Browser browser, String name, Object value) {
    try {
      return browser.parameter(name).equals(Optional.of(value));
    } catch (CallException e) {
      return false;
    }
  }
}
