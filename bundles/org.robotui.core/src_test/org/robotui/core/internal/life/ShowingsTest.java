package org.robotui.core.internal.life;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.api.UicType.Surface;
import org.robotui.api.host.HostListener;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicState;
import org.robotui.api.port.Arity;
import org.robotui.api.port.Publication;
import org.robotui.api.port.SourceId;
import org.robotui.api.port.StreamPort;
import org.robotui.api.show.ShowChoice;
import org.robotui.api.show.Showing;
import org.robotui.api.show.Subject;
import org.robotui.core.internal.support.Await;
import org.robotui.core.internal.support.CoreBench;
import org.robotui.core.internal.support.FakeRobot;
import org.robotui.core.internal.support.FakeView;
import org.robotui.data.geometry.Pose;
import org.robotui.data.image.Image;
import org.robotui.data.joint.JointState;
import org.robotui.data.navigation.PoseEstimate;

class ShowingsTest {
  private static final SourceId JOINTS = new SourceId("base", "joints");
  private static final Subject SUBJECT = Subject.Stream.of(JOINTS);
  private static final String CONFIGURATION = """
      ruics:
        R:
          rfics:
            base: {type: robot}
          uics:
            first: {type: plot, title: Speeds}
            second: {type: plot}
      """;

  @TempDir
  Path folder;

  private final List<Object> wanted = new CopyOnWriteArrayList<>();
  private final FakeRobot robot = new FakeRobot("robot");
  private CoreBench bench;
  private Publication<JointState> published;

  @BeforeEach
  void open() {
    bench = new CoreBench(folder);
    bench.core.listen(new HostListener() {
      @Override
      public void viewWanted(String ruic, String uic, String showing, Subject subject) {
        wanted.add(List.of(ruic, uic, showing, subject));
      }
    });
    bench.registry.add(robot, "bundle");
    bench.registry.add(new FakeView("plot").shows(Showing.numbers("plot", "Plot")), "bundle");
  }

  @AfterEach
  void close() {
    bench.close();
  }

  @Test
  void eachViewOfATypeThatShowsItIsOffered() {
    Ruic ruic = start();
    assertEquals(List.of("second Fake view ", "first Speeds "), texts(ruic.showChoices(SUBJECT)));
  }

  @Test
  void whatCannotShowItSaysWhyAndComesLast() {
    bench.registry.add(new FakeView("camera").shows(Showing.streams("image", "A picture", List.of(Image.class))),
        "bundle");
    bench.registry.add(new FakeView("table").shows(Showing.streams("joints", "Joints", List.of(JointState.class))),
        "bundle");
    Ruic ruic = start();
    assertEquals(
        List.of("table Fake view ", "second Fake view ", "first Speeds ", " Fake view shows no JointState"),
        texts(ruic.showChoices(SUBJECT)));
  }

  @Test
  void aTypeIsTakenWhereItExtendsOneThatIsDeclared() {
    bench.registry.add(new FakeView("poses").shows(Showing.streams("pose", "Pose", List.of(Pose.class))), "bundle");
    Ruic ruic = start();
    robot.context().offers().stream(new StreamPort<>("estimate", PoseEstimate.class, Arity.MANY, ""), on -> {});
    assertEquals(1, ruic.showChoices(Subject.Stream.of(new SourceId("base", "estimate"))).stream()
        .filter(c -> c.opens().equals(Optional.of("poses"))).count());
  }

  @Test
  void whatIsNotOfferedCannotBeShown() {
    assertEquals(List.of("second Fake view not offered now", "first Speeds not offered now"),
        texts(start().showChoices(Subject.Stream.of(new SourceId("base", "gone")))));
  }

  @Test
  void framesAndNodesAreShownByOthers() {
    bench.registry.add(new FakeView("log").shows(Showing.nodes("node", "Log")), "bundle");
    assertEquals(List.of("log Fake view "), texts(start().showChoices(new Subject.Node("/amcl"))));
  }

  @Test
  void viewsForOtherSurfacesAreNotOffered() {
    bench.registry.add(
        new FakeView("text").on(Surface.TEXT).shows(Showing.streams("print", "Print", List.of(JointState.class))),
        "bundle");
    assertEquals(2, start().showChoices(SUBJECT).size());
  }

  @Test
  void aTypeThatThrowsDoesNotTakeTheOthersAlong() {
    bench.registry.add(new FakeView("bad") {
      @Override
      public List<Showing> showings() {
        throw new IllegalStateException("made to fail");
      }
    }, "bundle");
    assertEquals(2, start().showChoices(SUBJECT).size());
  }

  @Test
  void aViewThatIsNotOpenIsOpenedForIt() {
    bench.registry.add(new FakeView("table").shows(Showing.streams("joints", "Joints", List.of(JointState.class))),
        "bundle");
    Ruic ruic = start();
    ruic.show(ruic.showChoices(SUBJECT).getFirst(), SUBJECT);
    Await.until("the application was told", () -> !wanted.isEmpty());
    assertEquals(List.of(List.of("R", "table", "joints", SUBJECT)), wanted);
    assertEquals(List.of("first", "second", "table"), ruic.arranging().now().views());

    ruic.arranging().arrange(ruic.arranging().now().without("first").without("second"));
    Await.until("both are closed", () -> ruic.snapshot().components().size() == 2);
    ShowChoice again = ruic.showChoices(SUBJECT).stream().filter(c -> c.showing().id().equals("plot")).findFirst()
        .orElseThrow();
    assertEquals("first", again.view(), "one that is closed before one more");
    ruic.show(again, SUBJECT);
    Await.until("it was told again", () -> wanted.size() == 2);
  }

  @Test
  void theApplicationIsToldWhichViewIsWanted() {
    Ruic ruic = start();
    ShowChoice choice = ruic.showChoices(SUBJECT).getFirst();
    ruic.show(choice, SUBJECT);
    Await.until("the application was told", () -> !wanted.isEmpty());
    assertEquals(List.of(List.of("R", "second", "plot", SUBJECT)), wanted);
  }

  @Test
  void theNewestValueIsThereFromTheFirstOn() {
    Ruic ruic = start();
    assertEquals(Optional.empty(), ruic.newest(JOINTS));
    JointState value = new JointState(List.of(new JointState.Joint("a", 1, 0, 0)));
    published.publish(value, Optional.empty(), System.nanoTime(), Optional.empty());
    assertEquals(Optional.of(value), ruic.newest(JOINTS).map(e -> e.value()));
    assertEquals(Optional.empty(), ruic.newest(new SourceId("base", "gone")));
  }

  private Ruic start() {
    bench.load(CONFIGURATION);
    Ruic ruic = bench.ruic();
    bench.await("first", RuicState.INITIALIZED);
    bench.await("second", RuicState.INITIALIZED);
    published = robot.context().offers().stream(new StreamPort<>("joints", JointState.class, Arity.MANY, ""), on -> {});
    return ruic;
  }

  /** In order: id, title and obstacle. */
  private static List<String> texts(List<ShowChoice> choices) {
    return choices.stream().map(c -> c.view() + " " + c.title() + " " + c.obstacle()).toList();
  }
}
