package org.robotui.roblets;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.roblets.brain.BrainRule;
import org.robotui.roblets.roblet.InputMessage;
import org.robotui.roblets.roblet.OutputMessage;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletInfo;
import org.robotui.roblets.roblet.RobletRunner;
import org.robotui.roblets.roblet.RobletSpeech;
import org.robotui.roblets.roblet.RobletState;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyPath;
import org.robotui.roblets.tree.RecordMessage;
import org.robotui.roblets.wire.RobletStatus;

/** Roblets with a brain: they begin, speak, are spoken to, fail, and are started again. */
@Timeout(120)
class RobletLifeTest {
  private static final BodyPath BEAT = BodyPath.parse("heart/heartBeat/@beat");
  /** More beats than an instance lives for: each begins at its own multiple of it. */
  private static final long LIFE = 1_000_000;

  private final TestBody body = new TestBody();

  record HeartBeat(long beat) {}

  record Turn(double angle) {}

  @OutputMessage(HeartBeat.class)
  @RobletInfo(name = "heart", frequency = 50)
  static final class Heart implements Roblet {
    private final AtomicLong beats;
    private final AtomicBoolean fail;

    Heart(AtomicLong beats, AtomicBoolean fail) {
      this.beats = beats;
      this.fail = fail;
    }

    @Override
    public void run(RobletSpeech speech) {
      if (fail.getAndSet(false)) {
        throw new IllegalStateException("it stopped");
      }
      speech.say(new HeartBeat(beats.incrementAndGet()));
    }
  }

  @InputMessage(Turn.class)
  @OutputMessage(Turn.class)
  @RobletInfo(frequency = 20, friends = "heart2")
  static final class RudderRoblet implements Roblet {
    private double angle;

    @Override
    public void run(RobletSpeech speech) {
      speech.say(new Turn(angle));
      speech.tell("heart2", RecordMessage.ofRecord(new Turn(angle)));
    }

    @Override
    public void receive(String from, BodyElement message, RobletSpeech speech) {
      angle = RecordMessage.of(Turn.class).record(message).angle();
    }
  }

  @OutputMessage(Turn.class)
  @RobletInfo(name = "heart2", frequency = 20)
  static final class Friend implements Roblet {
    private String heard = "nobody";

    @Override
    public void run(RobletSpeech speech) {
      speech.say(BodyElement.of("turn").with("of", heard));
      assertFalse(speech.tell("rudder", BodyElement.of("turn")), "friendship goes one way");
    }

    @Override
    public void receive(String from, BodyElement message, RobletSpeech speech) {
      heard = from + message.attribute("angle").orElse("");
    }
  }

  RobletLifeTest() throws IOException {
    // the body begins in its field
  }

  @AfterEach
  void end() {
    body.close();
  }

  private String state(String roblet) {
    return body.brain().roblets().stream().filter(s -> s.form().name().equals(roblet)).map(RobletStatus::state)
        .findFirst().orElse("");
  }

  private long beat() {
    return (long) body.brain().bodymap().snapshot().number(BEAT).orElse(0);
  }

  @Test
  void a_roblet_is_found_and_heard_and_goes_with_a_word() throws IOException {
    RobletRunner heart = body.run(() -> new Heart(new AtomicLong(), new AtomicBoolean()));
    body.await("it is heard", () -> beat() > 5 && state("heart").equals(RobletStatus.RUNNING));
    body.await("what it said is remembered", () -> body.brain().bodymap().history("heart", "heartBeat").size() > 2);
    heart.close();
    assertEquals(RobletState.STOPPED, heart.state());
    body.await("that is told", () -> state("heart").equals(RobletStatus.STOPPED));
  }

  @Test
  void one_that_fails_is_started_again_and_others_do_not_notice() throws IOException {
    AtomicBoolean fail = new AtomicBoolean();
    AtomicInteger made = new AtomicInteger();
    RobletRunner heart = body.run(() -> new Heart(new AtomicLong(made.incrementAndGet() * LIFE), fail));
    body.run(RudderRoblet::new);
    body.await("both are heard", () -> beat() > LIFE + 50 && state("rudder").equals(RobletStatus.RUNNING)
        && body.brain().bodymap().snapshot().entry("rudder", "turn").isPresent());
    long before = sequenceOfRudder();
    fail.set(true);
    body.await("that is told with its reason", () -> body.brain().roblets().stream()
        .anyMatch(s -> s.state().equals("failed") && s.reason().contains("it stopped")));
    body.await("another instance beats", () -> heart.restarts() == 1 && beat() > 2 * LIFE);
    assertEquals(2, made.get());
    body.await("and goes on", () -> state("heart").equals(RobletStatus.RUNNING));
    body.await("the other one did all the while", () -> sequenceOfRudder() > before + 5);
    RobletStatus rudder = body.brain().roblets().getLast();
    assertEquals(1, rudder.tally().runs());
    assertEquals(0, rudder.tally().late() + rudder.tally().doubled());
  }

  private long sequenceOfRudder() {
    return body.brain().bodymap().snapshot().entry("rudder", "turn").orElseThrow().sequence();
  }

  @Test
  void rules_speak_to_roblets_and_one_that_fails_harms_no_other() throws IOException {
    body.brain().rule(BrainRule.when("wrong", "heart/heartBeat", (change, brain) -> {
      throw new IllegalStateException("a rule of a test");
    }));
    body.brain().rule(BrainRule.when("turn", "heart/heartBeat[@beat]",
        (change, brain) -> brain.say("rudder", new Turn(change.now().element().needed("beat") / 1000))));
    body.run(RudderRoblet::new);
    body.run(() -> new Heart(new AtomicLong(7000), new AtomicBoolean()));
    BodyPath angle = BodyPath.parse("rudder/turn/@angle");
    body.await("the rudder turns", () -> body.brain().bodymap().snapshot().number(angle).orElse(0) > 7);
  }

  @Test
  void friends_speak_without_the_brain_one_way() throws IOException {
    body.run(RudderRoblet::new);
    body.run(Friend::new);
    BodyPath heard = BodyPath.parse("heart2/turn/@of");
    body.await("the friend was told",
        () -> body.brain().bodymap().snapshot().values(heard).equals(List.of("rudder0.0")));
    body.await("it is said to run", () -> state("heart2").equals(RobletStatus.RUNNING));
    RobletStatus rudder = body.brain().roblets().getLast();
    assertEquals(0, rudder.tally().lost(), () -> "what a friend was told is not missing at the brain: " + rudder);
  }

  @Test
  void a_brain_that_was_started_again_finds_its_roblets() throws IOException {
    body.run(() -> new Heart(new AtomicLong(), new AtomicBoolean()));
    body.await("it is heard", () -> beat() > 5);
    body.restartBrain();
    body.await("it is heard again", () -> beat() > 10);
  }

  @Test
  void loss_disorder_and_doubles_are_survived_and_counted() throws IOException {
    BadNetwork network = body.badNetwork();
    body.run(() -> new Heart(new AtomicLong(), new AtomicBoolean()), network.port());
    AtomicLong last = new AtomicLong();
    AtomicInteger back = new AtomicInteger();
    body.brain().bodymap().listen(BEAT, change -> {
      long beat = (long) change.now().element().needed("beat");
      back.addAndGet(beat <= last.getAndSet(beat) ? 1 : 0);
    });
    body.await("much is heard", () -> beat() > 150);
    RobletStatus heart = body.brain().roblets().getFirst();
    assertEquals(0, back.get(), "nothing goes back in time");
    assertTrue(heart.tally().lost() > 0 && heart.tally().late() > 0 && heart.tally().doubled() > 0, heart::toString);
    assertEquals(Set.of(), body.brain().watchers());
  }
}
