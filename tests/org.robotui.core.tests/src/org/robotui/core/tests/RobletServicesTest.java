package org.robotui.core.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Dictionary;
import java.util.Hashtable;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.osgi.framework.Bundle;
import org.osgi.framework.PrototypeServiceFactory;
import org.osgi.framework.ServiceRegistration;
import org.robotui.roblets.brain.Brain;
import org.robotui.roblets.brain.BrainOptions;
import org.robotui.roblets.roblet.Roblet;
import org.robotui.roblets.roblet.RobletSpeech;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.wire.RobletForm;
import org.robotui.roblets.wire.RobletStatus;

/** Roblets that are registered as services live while they are. */
class RobletServicesTest {
  private static final String BUNDLE = "org.robotui.rfic.roblets";
  private static final ThreadFactory THREADS = Thread.ofPlatform().daemon().factory();

  private final List<Clock> made = new CopyOnWriteArrayList<>();
  private final List<Clock> given = new CopyOnWriteArrayList<>();
  private Brain brain;

  /** Beats, and fails once each time that it shall. */
  private static final class Clock implements Roblet {
    private final AtomicBoolean fails = new AtomicBoolean();
    private volatile boolean stopped;

    @Override
    public RobletForm form() {
      return new RobletForm("clock", 20, List.of(), List.of(), List.of());
    }

    @Override
    public void run(RobletSpeech speech) {
      if (fails.getAndSet(false)) {
        throw new IllegalStateException("it shall fail");
      }
      speech.say(BodyElement.of("beat"));
    }

    @Override
    public void stop() {
      stopped = true;
    }
  }

  /** Another instance for each that asks. */
  private final class Clocks implements PrototypeServiceFactory<Roblet> {
    @Override
    public Roblet getService(Bundle bundle, ServiceRegistration<Roblet> registration) {
      Clock clock = new Clock();
      made.add(clock);
      return clock;
    }

    @Override
    public void ungetService(Bundle bundle, ServiceRegistration<Roblet> registration, Roblet service) {
      given.add((Clock) service);
    }
  }

  @BeforeEach
  void open() throws Exception {
    Bundles.start(BUNDLE);
    brain = new Brain(BrainOptions.loopback(THREADS, 0, "test"));
  }

  @AfterEach
  void close() {
    brain.close();
  }

  private Dictionary<String, Object> properties() {
    Dictionary<String, Object> properties = new Hashtable<>();
    properties.put("roblets.brain", "127.0.0.1:" + brain.port());
    return properties;
  }

  private Optional<RobletStatus> clock() {
    return brain.roblets().stream().filter(each -> each.form().name().equals("clock")).findFirst();
  }

  private void awaitState(String state, long restarts) {
    Eventually.await("the clock is " + state,
        () -> clock().filter(each -> each.state().equals(state) && each.restarts() == restarts).isPresent(),
        this::clock);
  }

  @Test
  void aRobletLivesWhileItsServiceIsThereAndAnotherInstanceTakesItsPlaceWhereItFails() {
    ServiceRegistration<Roblet> registration =
        Bundles.context().registerService(Roblet.class, new Clocks(), properties());
    awaitState(RobletStatus.RUNNING, 0);

    made.getLast().fails.set(true);
    awaitState(RobletStatus.RUNNING, 1);
    assertEquals(2, made.size());
    Eventually.await("the first one was given back", () -> given.equals(List.of(made.getFirst())), () -> given);

    registration.unregister();
    Eventually.await("it has ended", () -> made.getLast().stopped, () -> made);
    Eventually.await("the brain has been told",
        () -> clock().filter(each -> each.state().equals(RobletStatus.RUNNING)).isEmpty(), this::clock);
    Eventually.await("all were given back", () -> given.equals(made), () -> given);
  }

  @Test
  void aSingleInstanceIsStartedAgainAndEndsWithTheComponentThatRunsIt() throws Exception {
    Clock clock = new Clock();
    ServiceRegistration<Roblet> registration =
        Bundles.context().registerService(Roblet.class, clock, properties());
    awaitState(RobletStatus.RUNNING, 0);

    clock.fails.set(true);
    awaitState(RobletStatus.RUNNING, 1);

    clock.stopped = false;
    Bundles.stop(BUNDLE);
    Eventually.await("it has ended", () -> clock.stopped, this::clock);
    Bundles.start(BUNDLE);
    awaitState(RobletStatus.RUNNING, 0);
    registration.unregister();
  }
}
