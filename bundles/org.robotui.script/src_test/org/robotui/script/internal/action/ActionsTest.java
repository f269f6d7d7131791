package org.robotui.script.internal.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.api.command.Principal;
import org.robotui.api.host.PortStatus;
import org.robotui.api.layout.Arrangement;
import org.robotui.api.layout.DropTarget;
import org.robotui.api.layout.Edge;
import org.robotui.api.layout.Layout;
import org.robotui.api.port.Arity;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Envelope;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.api.script.ActionWatch;
import org.robotui.api.script.ScriptFunction;
import org.robotui.api.script.ScriptFunctions;
import org.robotui.api.script.ScriptLine;
import org.robotui.data.Data;
import org.robotui.data.FrameId;
import org.robotui.data.command.VelocityCommand;
import org.robotui.data.navigation.NavigationGoal;
import org.robotui.geometry.RigidTransform;
import org.robotui.script.internal.engine.Console;
import org.robotui.testkit.host.FakeRuic;

/** What users do becomes lines, and the lines do the same again. */
@Timeout(120)
class ActionsTest {
  private static final Principal YOU = new Principal("window", "You", Principal.Kind.WINDOW);
  private static final Principal PROGRAM = new Principal("script-9", "a script", Principal.Kind.SCRIPT);

  private static final SourceId VELOCITY = new SourceId("base", "cmd_vel");
  private static final SourceId GOAL = new SourceId("base", "goal");

  private final Map<SourceId, Envelope<?>> out = new HashMap<>();
  private long count;
  private final Console console = new Console();
  private final FakeRuic natalie = new FakeRuic("Natalie");
  private HostWatch watch;

  @BeforeEach
  void robot() {
    console.host.add(natalie);
    natalie.laidOut(new Layout.Tabs(List.of("map", "plot", "log")));
    watch = new HostWatch(console.host);
  }

  @AfterEach
  void end() {
    console.close();
  }

  private void arrange(Arrangement wanted) {
    natalie.arranging().arrange(wanted);
  }

  private Arrangement now() {
    return natalie.arranging().now();
  }

  /** The lines of what was done, which must lead to the same from how it was before. */
  private List<String> again(Arrangement before) {
    Arrangement wanted = now();
    List<String> lines = watch.next();
    arrange(before);
    console.value(String.join("\n", lines));
    assertEquals(wanted, now());
    return lines;
  }

  @Test
  void viewsThatAreOpenedClosedAndShownAreSaid() {
    Arrangement before = now();
    arrange(before.fronted("log"));
    assertEquals(List.of("showView(\"log\", \"Natalie\");"), again(before));
    before = now();
    watch.next();
    arrange(before.closed("plot"));
    assertEquals(List.of("closeView(\"plot\", \"Natalie\");"), again(before));
    before = now();
    watch.next();
    arrange(before.opened("plot", natalie.arranging().written().layout()));
    assertEquals(List.of("openView(\"plot\", \"Natalie\");"), again(before));
  }

  @Test
  void oneMoreOfATypeIsOpenedByItsType() {
    arrange(now().adding(new Arrangement.Added("camera-2", "camera")).opened("camera-2", now().layout()));
    assertEquals(List.of("openView(\"camera\", \"Natalie\");"), watch.next());
  }

  @Test
  void whatWasDraggedIsSaidToBeNoLine() {
    arrange(now().with("log", new DropTarget.Border(0, Edge.LEFT)));
    List<String> lines = watch.next();
    assertEquals(1, lines.size());
    assertTrue(lines.getFirst().startsWith("// The views of \"Natalie\" were arranged by hand"), lines.toString());
    assertEquals(List.of(), watch.next());
  }

  @Test
  void aPerspectiveIsSaidInPlaceOfItsViews() {
    natalie.arranging().keep("Drive");
    natalie.arranging().forget("Drive");
    watch.next();
    natalie.arranging().keep("Look");
    assertEquals(List.of("perspective(\"Look\", \"Natalie\");"), watch.next());
  }

  @Test
  void controlAndStopsOfUsersAreSaidAndThoseOfScriptsAreNot() {
    String robot = natalie.authority().robot();
    natalie.authority().take(YOU, false);
    natalie.authority().stop(YOU);
    assertEquals(List.of(ScriptLine.call("takeControl", robot), ScriptLine.call("stop", robot)), watch.next());
    natalie.authority().releaseStop(YOU);
    natalie.authority().giveBack(YOU);
    assertEquals(List.of(ScriptLine.call("giveBackControl", robot), ScriptLine.call("releaseStop", robot)),
        watch.next());
    natalie.authority().take(PROGRAM, false);
    assertEquals(List.of(), watch.next());
  }

  @Test
  void selectionsAndWhatIsTakenAwayAreSaid() {
    natalie.selection().set(new LinkedHashSet<>(List.of("r2", "r1")));
    assertEquals(List.of("selectRobots([\"r2\", \"r1\"], \"Natalie\");"), watch.next());
    console.host.remove(natalie);
    assertEquals(List.of("remove(\"Natalie\");"), watch.next());
  }

  @Test
  void theRecorderWaitsAsTheUserDidAndOneThatFailsHidesNothing() throws Exception {
    List<String> lines = new CopyOnWriteArrayList<>();
    ScriptFunctions failing = new Watched(() -> {
      throw new IllegalStateException("on purpose");
    });
    try (ActionRecorder recorder = new ActionRecorder(console.host, List.of(failing), lines::add)) {
      arrange(now().fronted("log"));
      while (lines.isEmpty()) {
        Thread.sleep(10);
      }
      Thread.sleep(700); // the pause of the user, which the recorder writes down
      arrange(now().fronted("map"));
    }
    assertEquals(3, lines.size(), "what was done last is said at the end: " + lines);
    assertEquals("showView(\"log\", \"Natalie\");", lines.getFirst());
    assertTrue(lines.get(1).matches("sleep\\([0-9]+\\.[0-9]\\);"), lines.get(1));
    assertEquals("showView(\"map\", \"Natalie\");", lines.getLast());
  }

  @Test
  void textsAreWrittenSuchThatTheyAreReadAsTheyWere() {
    String text = "a \"b\" \\ c\nd \u00e4 \u2028";
    assertEquals(text, console.value(ScriptLine.literal(text)));
    assertEquals("f(1, 0.25, true, [\"x\"]);", ScriptLine.call("f", 1, 0.25, true, List.of("x")));
  }

  /** Functions of a bundle that watches. */
  private record Watched(ActionWatch own) implements ScriptFunctions {
    @Override
    public List<ScriptFunction> functions() {
      return List.of();
    }

    @Override
    public Optional<ActionWatch> watch() {
      return Optional.of(own);
    }
  }

  @Test
  void goalsThatUsersSendAreSaidAndSentAgain() {
    NavigationGoal goal =
        new NavigationGoal(new FrameId("Natalie", "map"), RigidTransform.planar(2, -1.5, Math.PI / 2));
    CommandWatch sent = commands();
    sending(GOAL, goal);
    assertEquals(List.of(), sent.next(1), "nobody has control who is a user");
    natalie.authority().take(YOU, false);
    sending(GOAL, goal);
    List<String> lines = lines(sent.next(2));
    assertTrue(lines.getFirst().startsWith("send(\"base.goal\", {frame: \"map\", pose: {translation: {x: 2"),
        lines::toString);
    assertTrue(lines.getFirst().endsWith(", 1, \"Natalie\");"), lines::toString);
    assertEquals(List.of(), sent.next(3), "once");
    natalie.authority().giveBack(YOU);
    console.run("takeControl(); " + lines.getFirst());
    assertEquals(goal, natalie.ports().commands().getLast());
  }

  @Test
  void aMotionIsOneLineThatDrivesTheSameWay() {
    CommandWatch sent = commands();
    natalie.authority().take(YOU, false);
    long second = 1_000_000_000L;
    sending(VELOCITY, VelocityCommand.planar(0.3, 0));
    assertEquals(List.of(), sent.next(second));
    sending(VELOCITY, VelocityCommand.planar(0.301, 0));
    assertEquals(List.of(), sent.next(second + second / 5));
    sending(VELOCITY, VelocityCommand.planar(0.3, 0.5));
    assertEquals(List.of(), sent.next(second + second * 2 / 5));
    sending(VELOCITY, VelocityCommand.ZERO);
    CommandWatch.Done done = sent.next(second + second * 3 / 5).getFirst();
    assertEquals("driveAlong([[0.3, 0, 0.4], [0.3, 0.5, 0.2]], \"base.cmd_vel\", \"Natalie\");", done.line());
    assertEquals(0.6, done.seconds(), 1e-9);
    natalie.authority().giveBack(YOU);
    console.run("takeControl(); " + done.line());
    assertTrue(natalie.ports().commands().contains(VelocityCommand.planar(0.3, 0.5)),
        () -> natalie.ports().commands().toString());
    assertEquals(VelocityCommand.ZERO, natalie.ports().commands().getLast());
  }

  @Test
  void aMotionThatIsNotRenewedEndsWhereItWasHeardLast() {
    CommandWatch sent = commands();
    natalie.authority().take(YOU, false);
    long second = 1_000_000_000L;
    sending(VELOCITY, VelocityCommand.planar(0.3, 0));
    sent.next(second);
    sending(VELOCITY, VelocityCommand.planar(0.3, 0));
    sent.next(second * 2);
    assertEquals(List.of("driveAlong([[0.3, 0, 1]], \"base.cmd_vel\", \"Natalie\");"), lines(sent.next(second * 3)));
    sending(VELOCITY, VelocityCommand.planar(0.3, 0));
    sent.next(second * 4);
    assertEquals(1, sent.end(second * 5).size(), "the end of what is written down ends it");
  }

  private CommandWatch commands() {
    natalie.offering(port(VELOCITY, "VelocityCommand"), port(GOAL, "NavigationGoal"));
    natalie.ports().offer("base", new CommandPort<>("cmd_vel", VelocityCommand.class, Arity.MANY, ""),
        new CommandPort<>("goal", NavigationGoal.class, Arity.MANY, ""));
    return new CommandWatch(console.host, (ruic, port) -> Optional.ofNullable(out.get(port)));
  }

  private void sending(SourceId port, Data command) {
    out.put(port, new Envelope<>(command, port, count++, Optional.empty(), 0, Optional.empty()));
  }

  private static PortStatus port(SourceId id, String type) {
    return new PortStatus(id, PortKind.COMMAND, type, false, 0, 0, 0, false, 0, "", "");
  }

  private static List<String> lines(List<CommandWatch.Done> done) {
    return done.stream().map(CommandWatch.Done::line).toList();
  }
}
