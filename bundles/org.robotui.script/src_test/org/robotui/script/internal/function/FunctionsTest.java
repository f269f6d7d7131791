package org.robotui.script.internal.function;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.ViewFit;
import org.robotui.api.layout.Layout;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CallOutcome;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.ServiceReply;
import org.robotui.api.port.ServiceRequest;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.data.array.Doubles;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.data.sensor.Battery;
import org.robotui.script.internal.engine.Console;
import org.robotui.testkit.FakeSettings;
import org.robotui.testkit.host.FakeRuic;

class FunctionsTest {
  private static final SourceId BATTERY = new SourceId("base", "battery");
  private static final SourceId VELOCITY = new SourceId("base", "cmd_vel");
  private static final Principal YOU = new Principal("window", "You", Principal.Kind.WINDOW);

  private final Console console = new Console();
  private final FakeRuic natalie = new FakeRuic("Natalie");

  @BeforeEach
  void robot() {
    console.host.add(natalie).add(new FakeRuic("Keira"));
    natalie.laidOut(new Layout.Tabs(List.of("map", "plot")));
    natalie.offering(new PortStatus(VELOCITY, PortKind.COMMAND, "VelocityCommand", false, 0, 0, 0, false, 0, "", ""));
    natalie.ports().offer("base", new CommandPort<>("cmd_vel", VelocityCommand.class, Arity.MANY, ""),
        new CommandPort<>("goal", NavigationGoal.class, Arity.MANY, ""),
        new StreamPort<>("battery", Battery.class, Arity.MANY, ""),
        new CallPort<>("services", ServiceRequest.class, ServiceReply.class, Arity.MANY, ""));
  }

  @AfterEach
  void end() {
    console.close();
  }

  private static Battery charged(double charge) {
    return new Battery(12.5, -1, charge, Battery.Status.DISCHARGING);
  }

  @Test
  void listsRobotUisAndRobots() {
    assertEquals(List.of("Natalie", "Keira"), console.value("uis().map(u => u.name)"));
    assertEquals("connected", console.value("uis()[0].link"));
    assertEquals("Keira", console.value("use('Keira')"));
    assertTrue(console.failure("use('Nobody')").contains("there are: Natalie, Keira"));
    natalie.authority().take(YOU, false);
    assertEquals("You", console.value("robots()[0].control"));
  }

  @Test
  void readsValuesByTheNamesOfTheirFields() {
    natalie.ports().put(BATTERY, charged(0.8));
    assertEquals(12.5, console.value("value('base.battery').voltage"));
    assertEquals("DISCHARGING", console.value("value('base.battery').status"));
    assertEquals(List.of("voltage", "current", "charge", "status"),
        console.value("Object.keys(value('base.battery'))"));
    assertEquals("{\"voltage\":12.5,\"current\":-1,\"charge\":0.8,\"status\":\"DISCHARGING\"}",
        console.value("JSON.stringify(value('base.battery'))"));
    assertEquals(true, console.value("age('base.battery') < 60"));
    assertEquals(0.8, console.value("message('base.battery').charge"));
  }

  @Test
  void saysWhyThereIsNoValue() {
    assertEquals("test.js:1: no stream base.nothing is offered now", console.failure("value('base.nothing')"));
    assertTrue(console.failure("value('odom')").contains("as base.odom"));
    assertEquals("test.js:1: base.battery: no data yet", console.failure("value('base.battery')"));
  }

  @Test
  void takesAllThatCame() {
    natalie.ports().put(BATTERY, charged(0.8));
    natalie.ports().put(BATTERY, charged(0.7));
    assertEquals(List.of(0.8, 0.7), console.value("take('base.battery').map(b => b.charge)"));
    assertEquals(List.of(), console.value("take('base.battery')"));
  }

  @Test
  void waitsForConditions() {
    assertEquals(3.0, console.value("let n = 0; waitFor(() => ++n == 3 ? n : false)"));
    assertEquals("test.js:1: waited for 50 ms in vain", console.failure("waitFor(() => 0, 0.05)"));
    assertEquals("test.js:1: my own", console.failure("waitFor(() => { throw new Error('my own'); })"));
  }

  @Test
  void waitsForValues() throws InterruptedException {
    natalie.ports().put(BATTERY, charged(0.5));
    Thread robot = Thread.ofPlatform().daemon().start(() -> {
      while (console.printed.size() < 2) {
        Thread.onSpinWait();
      }
      natalie.ports().put(BATTERY, charged(0.1));
    });
    assertEquals(0.1, console.value("print('begin');",
        "waitUntil('base.battery', b => { print(b.charge); return b.charge < 0.2; }).charge"));
    robot.join();
    assertEquals(List.of("begin", "0.5", "0.1"), console.printed, "each value is looked at once");
    assertEquals("test.js:1: waited for 30 ms for base.battery in vain",
        console.failure("waitUntil('base.battery', b => false, 0.03)"));
  }

  @Test
  void nothingMovesWithoutControl() {
    assertTrue(console.failure("drive(0.2, 0, 1)").contains("nobody has control of Natalie"));
    natalie.authority().take(YOU, false);
    assertTrue(console.failure("takeControl()").contains("You has control of Natalie"));
    assertTrue(console.failure("takeControl('Nobody')").contains("there are: Natalie, Keira"));
    console.run("takeControl('Natalie', true)");
    assertEquals("the script", natalie.authority().holder().orElseThrow().label());
  }

  @Test
  void drivesAndStops() {
    console.run("takeControl(); drive(0.2, -0.1, 1);");
    List<String> sent = natalie.ports().sent();
    String motion = VELOCITY + " " + VelocityCommand.planar(0.2, -0.1);
    assertTrue(sent.size() >= 4 && sent.subList(0, 2).equals(List.of(motion, motion)), sent.toString());
    assertEquals(List.of(VELOCITY + " " + VelocityCommand.ZERO, "release"), sent.subList(sent.size() - 2, sent.size()));
  }

  @Test
  void aLatchedStopEndsTheDriveAndTheScript() throws InterruptedException {
    Thread user = Thread.ofPlatform().daemon().start(() -> {
      while (natalie.ports().sent().isEmpty()) {
        Thread.onSpinWait();
      }
      natalie.authority().stop(YOU);
    });
    assertEquals("test.js:2: Natalie is stopped", console.failure("takeControl();", "drive(0.2, 0, 60);"));
    user.join();
    assertEquals("release", natalie.ports().sent().getLast());
    console.run("releaseStop()");
    assertEquals(Optional.empty(), natalie.authority().stoppedBy());
    console.run("stop()");
    assertEquals("the script", natalie.authority().stoppedBy().orElseThrow().label());
  }

  @Test
  void theEndOfASessionGivesBack() {
    console.run("takeControl(); drive(0.1, 0, 0.01)");
    console.session.close();
    assertEquals(Optional.empty(), natalie.authority().holder());
    assertEquals("close", natalie.ports().sent().getLast());
  }

  @Test
  void sendsCommandsOfAnyType() {
    console
        .run("takeControl(); send('base.goal', {frame: 'map', pose: {translation: {x: 2}, rotation: {yaw: Math.PI}}})");
    String sent = natalie.ports().sent().getLast();
    assertTrue(sent.startsWith("base.goal NavigationGoal[frame=Natalie:map") && sent.contains("x=2.0"), sent);
    assertTrue(
        console.failure("send('base.goal', {place: 'map'})").contains("has no field 'place'; it has frame, pose"));
    assertTrue(console.failure("send('base.cmd_vel', {linear: {x: 'fast'}})").contains("linear.x must be a number"));
    assertTrue(console.failure("send('base.cmd_vel', {linear: {x: NaN}})").contains("finite"));
    assertTrue(console.failure("send('base.nothing', {})").contains("no command base.nothing"));
  }

  @Test
  void callsAndGivesTheReply() {
    natalie.ports().answer(request -> new CallOutcome.Replied<>(
        new ServiceReply(new MapRecord("Reply", Map.of("sum", new FieldValue.Num(3, "3"),
            "all", new FieldValue.Numbers(Doubles.of(1, 2)))))));
    assertEquals(3.0, console.value("call('base.services', {service: '/add', arguments: {a: 1}}).value.sum"));
    assertEquals(List.of(1.0, 2.0), console.value("call('base.services', {service: '/add'}).value.all"));
    assertEquals("base.services ServiceRequest[service=/add, arguments={a=1.0}]", natalie.ports().sent().getFirst());
    natalie.ports().answer(request -> new CallOutcome.Failed<>("no such service"));
    assertEquals("test.js:1: base.services: no such service", console.failure("call('base.services', {})"));
  }

  @Test
  void opensAndClosesViews() {
    natalie.arranging().offer(new ViewFit("camera", "Camera", "", ViewFit.Fit.CONNECTED, "", List.of()));
    assertEquals(List.of("map", "plot"), console.value("views().filter(v => v.open).map(v => v.id)"));
    assertEquals("camera", console.value("openView('camera')"));
    assertEquals(List.of("map", "plot", "camera"), console.value("views().filter(v => v.open).map(v => v.id)"));
    console.run("closeView('map')");
    assertEquals(List.of("plot", "camera"), console.value("views().filter(v => v.open).map(v => v.id)"));
    assertTrue(console.failure("closeView('map')").contains("open are: plot, camera"));
    assertTrue(console.failure("openView('nothing')").contains("viewTypes()"));
  }

  @Test
  void readsAndChangesSettingsOfViews() {
    FakeSettings map = new FakeSettings(Schema.of(
        Setting.of("follow", new ValueType.Flag(), false, "follows the robot"),
        Setting.of("trail", new ValueType.Int(0, 100), 10L, "how many places")));
    natalie.settings("map", map);
    assertEquals("{\"follow\":false,\"trail\":10}", console.value("JSON.stringify(settings('map'))"));
    console.run("setSetting('map', 'follow', true); setSetting('map', 'trail', 25)");
    assertEquals(true, map.current().flag("follow"));
    assertEquals(25L, map.current().integer("trail"));
    assertTrue(console.failure("setSetting('map', 'colour', 1)").contains("there are: follow, trail"));
    assertTrue(console.failure("settings('plot')").contains("Natalie has no view 'plot' that runs"));
  }

  @Test
  void keepsAndAppliesPerspectives() {
    console.run("keepPerspective('all'); closeView('map')");
    assertEquals(List.of("all"), console.value("perspectives()"));
    console.run("perspective('all')");
    assertEquals(List.of("map", "plot"), natalie.arranging().now().views());
    assertTrue(console.failure("perspective('none')").contains("there are: all"));
  }

  @Test
  void helpTellsOfFunctionsAndTypes() {
    console.run("help('sleep'); help('Battery')");
    assertEquals("sleep(seconds)\n    Waits.", console.printed.getFirst());
    assertTrue(console.printed.getLast().contains("voltage (double): volts"), console.printed.getLast());
  }

  @Test
  void wrongArgumentsAreNamed() {
    assertTrue(console.failure("sleep('long')").contains("sleep(seconds): seconds must be a number, not \"long\""));
    assertTrue(console.failure("sleep(-1)").contains("from 0 to 86400"));
    assertTrue(console.failure("waitFor(3)").contains("a function such as () => true"));
  }

  @Test
  void completesFunctionsPortsAndViews() {
    assertEquals(List.of("waitFor", "waitForLink", "waitUntil"), console.session.complete("wait").words());
    assertEquals(List.of("base.cmd_vel"), console.session.complete("x = value(\"base.").words());
    assertEquals(11, console.session.complete("x = value(\"base.").start());
    assertEquals(List.of("Natalie"), console.session.complete("use('N").words());
    console.run("var charge = 1");
    assertEquals(List.of("charge"), console.session.complete("print(char").words());
  }

  @Test
  void everyFunctionExplainsItself() {
    StandardFunctions.all(List::of).forEach(f -> assertTrue(f.help().endsWith(".") && f.help().length() > 5, f.name()));
  }
}
