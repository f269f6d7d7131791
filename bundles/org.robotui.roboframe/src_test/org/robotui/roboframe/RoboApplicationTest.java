package org.robotui.roboframe;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.robotui.message.roboframe.LogLineStreamable;
import org.robotui.message.roboframe.ModuleStateStreamable;
import org.robotui.message.roboframe.ScanStreamable;
import org.robotui.message.roboframe.VelocityStreamable;
import org.robotui.roboframe.app.KeyInput;
import org.robotui.roboframe.app.ModuleChannels;
import org.robotui.roboframe.app.RoboApplication;
import org.robotui.roboframe.app.RoboModule;
import org.robotui.roboframe.app.RunPace;
import org.robotui.roboframe.board.ChannelKey;
import org.robotui.roboframe.board.KeyOutput;
import org.robotui.roboframe.board.KeyUse;

/** Modules of one application, and the channels between them. */
class RoboApplicationTest {
  private static final ChannelKey<VelocityStreamable> WANTED =
      ChannelKey.of("drive/wanted", VelocityStreamable.class);
  private static final ChannelKey<VelocityStreamable> DRIVEN =
      ChannelKey.of("drive/driven", VelocityStreamable.class);

  private RoboApplication application;

  @BeforeEach
  void open() throws IOException {
    application = new RoboApplication("robot", List.of(), BrokerWaiting.THREADS);
  }

  @AfterEach
  void close() {
    application.close();
  }

  /** Halves what is wanted, whenever that changes; a velocity that is not finite is its end. */
  private static final class Halving implements RoboModule {
    private final AtomicInteger cleaned;
    private KeyInput<VelocityStreamable> wanted;
    private KeyOutput<VelocityStreamable> driven;

    Halving(AtomicInteger cleaned) {
      this.cleaned = cleaned;
    }

    @Override
    public RunPace init(ModuleChannels channels) {
      wanted = channels.request(WANTED);
      driven = channels.advertise(DRIVEN);
      return new RunPace.OnChange();
    }

    @Override
    public void run() {
      wanted.take().ifPresent(posted -> {
        if (Double.isNaN(posted.value().forward())) {
          throw new IllegalStateException("no speed");
        }
        driven.push(new VelocityStreamable(posted.value().forward() / 2, 0, 0));
      });
    }

    @Override
    public void cleanUp() {
      cleaned.incrementAndGet();
    }
  }

  private static RoboModule cyclic(Runnable work) {
    return new RoboModule() {
      @Override
      public RunPace init(ModuleChannels channels) {
        return new RunPace.Cyclic(Duration.ofMillis(5));
      }

      @Override
      public void run() {
        work.run();
      }
    };
  }

  private ModuleStateStreamable state(String name) {
    return application.states().stream().filter(each -> each.name().equals(name)).findFirst().orElseThrow();
  }

  private boolean drives(double forward) {
    return application.blackboard().newest(DRIVEN).filter(each -> each.value().forward() == forward).isPresent();
  }

  @Test
  void modules_run_in_turns_and_on_changes() throws InterruptedException {
    AtomicInteger turns = new AtomicInteger();
    AtomicInteger cleaned = new AtomicInteger();
    application.add("counter", () -> cyclic(turns::incrementAndGet));
    application.add("halving", () -> new Halving(cleaned));
    try (KeyOutput<VelocityStreamable> wanted = application.blackboard().advertise(WANTED, "test");
        KeyUse kept = application.blackboard().request(DRIVEN, "test", posted -> {})) {
      wanted.push(new VelocityStreamable(1, 0, 0));
      BrokerWaiting.until("half of it", () -> drives(0.5));
      BrokerWaiting.until("several turns", () -> turns.get() > 3);
    }
    application.close(); // waits a second for modules; a busy machine may take longer
    BrokerWaiting.until("its end", () -> state("halving").text().equals("ended"));
    assertEquals(1, cleaned.get());
  }

  @Test
  void an_error_stops_one_module_alone_and_is_told() throws InterruptedException {
    Queue<LogLineStreamable> lines = new ConcurrentLinkedQueue<>();
    AtomicInteger turns = new AtomicInteger();
    AtomicInteger cleaned = new AtomicInteger();
    application.add("counter", () -> cyclic(turns::incrementAndGet));
    application.add("halving", () -> new Halving(cleaned));
    try (KeyOutput<VelocityStreamable> wanted = application.blackboard().advertise(WANTED, "test");
        KeyUse told = application.blackboard().request(RoboApplication.LOG_LINES, "test",
            posted -> lines.add(posted.value()))) {
      wanted.push(new VelocityStreamable(Double.NaN, 0, 0));
      BrokerWaiting.until("the end of the module", () -> state("halving").failed());
      assertEquals("stopped by IllegalStateException: no speed", state("halving").text());
      BrokerWaiting.until("a line", () -> lines.stream().anyMatch(line -> line.module().equals("halving")));
      assertEquals("robot has begun", lines.element().text());
      int before = turns.get();
      BrokerWaiting.until("turns of the other one", () -> turns.get() > before + 2);
      assertEquals(1, cleaned.get());
      assertFalse(application.restart("counter"), "it still runs");
      wanted.push(new VelocityStreamable(4, 0, 0)); // else the new one would find the bad value
      BrokerWaiting.until("a new life", () -> application.restart("halving"));
      BrokerWaiting.until("its work", () -> drives(2));
    }
  }

  @Test
  void what_a_module_used_is_given_back_when_it_ends() throws InterruptedException {
    application.add("halving", () -> new Halving(new AtomicInteger()));
    BrokerWaiting.until("its keys", () -> uses(DRIVEN));
    try (KeyOutput<VelocityStreamable> wanted = application.blackboard().advertise(WANTED, "test")) {
      wanted.push(new VelocityStreamable(Double.NaN, 0, 0));
      BrokerWaiting.until("no keys", () -> !uses(DRIVEN));
    }
  }

  private boolean uses(ChannelKey<?> key) {
    return application.blackboard().keys().stream().anyMatch(each -> each.name().equals(key.name()));
  }

  @Test
  void a_module_that_cannot_begin_is_told() throws InterruptedException {
    application.add("bad", () -> {
      throw new IllegalArgumentException("no camera");
    });
    BrokerWaiting.until("the failure", () -> state("bad").failed());
    assertTrue(state("bad").text().contains("no camera"), state("bad").text());
    assertThrows(IllegalArgumentException.class, () -> application.add("bad", () -> cyclic(() -> {})));
  }

  @Test
  void a_key_has_one_type() {
    try (KeyOutput<VelocityStreamable> wanted = application.blackboard().advertise(WANTED, "test")) {
      IllegalArgumentException other = assertThrows(IllegalArgumentException.class,
          () -> application.blackboard().advertise(ChannelKey.of(WANTED.name(), ScanStreamable.class), "other"));
      assertTrue(other.getMessage().contains("carries roboframe/Velocity here, not roboframe/Scan"),
          other.getMessage());
    }
    try (KeyOutput<ScanStreamable> free =
        application.blackboard().advertise(ChannelKey.of(WANTED.name(), ScanStreamable.class), "other")) {
      assertTrue(uses(WANTED), "nobody used it any more");
    }
    assertThrows(IllegalArgumentException.class, () -> ChannelKey.of("a key", ScanStreamable.class));
  }

  @Test
  void a_module_that_does_not_come_back_is_seen() throws InterruptedException {
    AtomicBoolean go = new AtomicBoolean();
    application.add("slow", () -> cyclic(() -> {
      while (!go.get()) {
        Thread.onSpinWait();
      }
    }));
    BrokerWaiting.until("its state", () -> state("slow").text().startsWith("runs since"));
    go.set(true);
    BrokerWaiting.until("its state", () -> state("slow").text().equals("running"));
  }
}
