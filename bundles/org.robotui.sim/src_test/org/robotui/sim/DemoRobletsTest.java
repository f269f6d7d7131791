package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ThreadFactory;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.roblets.body.BodyEntry;
import org.robotui.roblets.body.Bodymap;
import org.robotui.roblets.tree.BodyElement;
import org.robotui.roblets.tree.BodyPath;
import org.robotui.roblets.watch.BodyWatchListener;
import org.robotui.roblets.watch.BodyWatcher;
import org.robotui.roblets.wire.RobletStatus;

/** A robot on wheels as roblets, three of which are those of the boat. */
@Timeout(120)
class DemoRobletsTest {
  private static final ThreadFactory THREADS = Thread.ofPlatform().daemon().factory();

  private final Demo demo = Demo.start(Options.parse(List.of("--robot", "keira", "--speak", "roblets")));
  private final Bodymap body = new Bodymap(1);
  private final Set<String> roblets = new TreeSet<>();

  DemoRobletsTest() throws IOException {
    // it runs from its field on
  }

  @AfterEach
  void end() {
    demo.close();
  }

  private void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + Duration.ofSeconds(60).toNanos();
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() - end < 0, () -> what + ": " + body.snapshot().tree());
      try {
        Thread.sleep(10);
      } catch (InterruptedException e) {
        throw new AssertionError(e);
      }
    }
  }

  @Test
  void it_says_how_it_is_and_is_driven() throws IOException {
    String at = demo.addresses().get("ROBLETS_BRAIN");
    InetSocketAddress brain = new InetSocketAddress("127.0.0.1", Integer.parseInt(at.substring(at.indexOf(':') + 1)));
    BodyWatchListener listener = new BodyWatchListener() {
      @Override
      public void roster(RobletStatus status) {
        synchronized (roblets) {
          roblets.add(status.form().name());
        }
      }

      @Override
      public void said(String roblet, BodyEntry entry, byte[] bytes) {
        body.put(roblet, entry);
      }
    };
    try (BodyWatcher watcher = new BodyWatcher("me", brain, THREADS, listener)) {
      watcher.want(Set.of(BodyWatcher.ALL));
      await("all are known", () -> {
        synchronized (roblets) {
          return roblets.equals(Set.of("base", "battery", "compass", "heart", "localization"));
        }
      });
      await("all are heard", () -> body.snapshot().parts().size() == 5);
      BodyPath turning = BodyPath.parse("base/motion/@wz");
      await("it turns", () -> {
        watcher.ask("base", BodyElement.of("velocity").with("vx", 0).with("vy", 0).with("wz", 0.5));
        return body.snapshot().number(turning).orElse(0) > 0.2;
      });
    }
  }
}
