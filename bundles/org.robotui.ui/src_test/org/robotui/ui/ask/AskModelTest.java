package org.robotui.ui.ask;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.SourceId;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.FieldValue;
import org.robotui.data.record.MapRecord;
import org.robotui.ui.Health;

class AskModelTest {
  private static final long SECOND = 1_000_000_000L;
  private static final SourceId GRAPH = new SourceId("base", "graph");
  private static final Item STOP = new Item(Kind.SERVICE, "/stop", "std_srvs/Trigger");
  private static final Item MOTORS = new Item(Kind.SERVICE, "/motors", "std_srvs/SetBool");

  private final FakeBrowser robot = new FakeBrowser();
  private final List<BrowseInput.Robot> robots = new ArrayList<>(List.of(new BrowseInput.Robot(GRAPH, robot)));
  private final Deque<Runnable> background = new ArrayDeque<>();
  private final List<Asker.Report> reports = new ArrayList<>();
  private final List<String> cancelled = new ArrayList<>();
  private final Catalogue catalogue = new Catalogue(() -> robots, background::add, Kind.SERVICE);
  private final AskModel model = new AskModel(catalogue, new Questions((entry, values, report) -> {
    reports.add(report);
    return () -> cancelled.add(entry.item().name());
  }));

  private long now = System.nanoTime();

  private boolean pass(double seconds) {
    now += (long) (seconds * SECOND);
    boolean news = model.tick(now);
    work();
    return news;
  }

  private void work() {
    while (!background.isEmpty()) {
      background.poll().run();
    }
  }

  private Catalogue.Entry entry(Item item) {
    return new Catalogue.Entry(GRAPH, item);
  }

  @Test
  void listsWhatRobotsHaveInTheBackgroundAndNotTooOften() {
    robot.items = List.of(STOP, MOTORS);
    model.tick(now);
    assertFalse(model.shown().listing().asked(), "a tick does not wait for the robot");
    work();
    assertEquals(List.of(entry(STOP), entry(MOTORS)), model.shown().entries());
    for (int i = 0; i < 10; i++) {
      pass(0.1);
    }
    assertEquals(1, robot.lists);
    pass(1.1);
    assertEquals(2, robot.lists);
  }

  @Test
  void oneQuestionIsOpenAtATimeHoweverSlowTheRobotIs() {
    model.tick(now);
    model.tick(now + 10 * SECOND);
    assertEquals(1, background.size());
  }

  @Test
  void saysWhyThereIsNothing() {
    pass(0);
    robot.refusal = Optional.of("the master does not answer");
    pass(3);
    assertEquals(List.of("base: the master does not answer"), model.shown().listing().problems());
    robots.clear();
    pass(0.1);
    assertEquals(0, model.shown().listing().robots());
    assertEquals(List.of(), model.shown().listing().problems());
  }

  @Test
  void filtersByNameAndType() {
    robot.items = List.of(STOP, MOTORS);
    pass(0);
    model.filter(" SETBOOL ");
    assertEquals(List.of(entry(MOTORS)), model.shown().entries());
  }

  @Test
  void describesWhatIsChosenAndForgetsAnswersThatComeTooLate() {
    model.choose(entry(STOP));
    model.choose(entry(MOTORS));
    work();
    Detail.Known known = assertInstanceOf(Detail.Known.class, model.shown().detail().orElseThrow());
    assertEquals(MOTORS, known.entry().item());
    robot.refusal = Optional.of("gone");
    model.again();
    work();
    assertEquals(Optional.of(new Detail.Unknown(entry(MOTORS), "gone")), model.shown().detail());
  }

  @Test
  void followsAQuestionToItsEnd() {
    model.questions().ask(entry(STOP), Map.of());
    assertTrue(pass(0.1));
    DynamicRecord half = new MapRecord("F", Map.of("percent", new FieldValue.Num(50, "50")));
    reports.getFirst().progress("active");
    reports.getFirst().feedback(half);
    Asked running = model.shown().asked().getFirst();
    assertTrue(running.running());
    assertEquals("active", running.words());
    assertEquals(Optional.of(half), running.feedback());
    model.questions().cancel(running.number());
    assertEquals(List.of("/stop"), cancelled);
    reports.getFirst().end(Health.OK, "done", Optional.of(half));
    reports.getFirst().progress("too late");
    Asked ended = model.shown().asked().getFirst();
    assertFalse(ended.running());
    assertEquals("done", ended.words());
    model.questions().cancel(ended.number());
    assertEquals(1, cancelled.size(), "what has ended cannot be cancelled");
    assertTrue(pass(0.1), "the end is news");
    assertFalse(pass(0.1), "and then there is none");
  }

  @Test
  void keepsTheNewestQuestions() {
    for (int i = 0; i < 60; i++) {
      model.questions().ask(entry(STOP), Map.of());
    }
    assertEquals(50, model.shown().asked().size());
    assertEquals(59, model.shown().asked().getFirst().number());
  }
}
