package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.message.roboframe.GridStreamable;
import org.robotui.message.roboframe.ModuleStatesStreamable;
import org.robotui.message.roboframe.OdometryStreamable;
import org.robotui.message.roboframe.PictureStreamable;
import org.robotui.message.roboframe.PoseStreamable;
import org.robotui.message.roboframe.ScanStreamable;
import org.robotui.message.roboframe.TargetStreamable;
import org.robotui.message.roboframe.VelocityStreamable;
import org.robotui.roboframe.app.RoboApplication;
import org.robotui.roboframe.board.Blackboard;
import org.robotui.roboframe.board.ChannelKey;
import org.robotui.roboframe.board.Connector;
import org.robotui.roboframe.board.KeyOutput;
import org.robotui.roboframe.board.Posted;
import org.robotui.roboframe.board.KeyUse;
import org.robotui.roboframe.board.Router;

/** A simulated robot as an application of RoboFrame, seen by another one. */
@Timeout(120)
class DemoRoboframeTest {
  private static final ThreadFactory THREADS = Thread.ofPlatform().daemon().factory();

  private final Blackboard board = new Blackboard();
  private Demo demo;
  private Router router;

  @BeforeEach
  void begin() throws Exception {
    demo = Demo.start(Options.parse(List.of("--robot", "natalie", "--speak", "roboframe")));
    router = new Router(board, "test", List.of(Connector.parse("connect:" + demo.addresses().get("ROBOFRAME_ADDR"))),
        THREADS);
  }

  @AfterEach
  void end() {
    router.close();
    demo.close();
  }

  private <T extends Record> T await(String key, Class<T> type, Predicate<T> wanted) throws InterruptedException {
    return await(ChannelKey.of(key, type), wanted, () -> {});
  }

  /** Done again and again until it has been heard. */
  private <T> T await(ChannelKey<T> key, Predicate<T> wanted, Runnable again) throws InterruptedException {
    BlockingQueue<Posted<T>> heard = new LinkedBlockingQueue<>();
    try (KeyUse reading = board.request(key, "test", heard::add)) {
      long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
      while (true) {
        again.run();
        Posted<T> posted = heard.poll(200, TimeUnit.MILLISECONDS);
        if (posted != null && wanted.test(posted.value())) {
          return posted.value();
        }
        assertTrue(System.nanoTime() < end, "no such " + key.name());
      }
    }
  }

  @Test
  void what_she_senses_stands_on_her_blackboard() throws Exception {
    ScanStreamable scan = await("laser/scan", ScanStreamable.class, any -> true);
    assertEquals(361, scan.ranges().length);
    GridStreamable map = await("map", GridStreamable.class, any -> true);
    assertEquals(map.width() * map.height(), map.cells().remaining());
    ModuleStatesStreamable modules = await(RoboApplication.MODULES, m -> m.modules().size() == 4, () -> {});
    assertEquals(List.of("drive", "navigation", "team", "vision"),
        modules.modules().stream().map(m -> m.name()).toList());
    assertNotNull(await(ChannelKey.of("camera/picture", PictureStreamable.class),
        any -> true, () -> {}));
  }

  @Test
  void she_drives_and_goes_where_she_is_told() throws Exception {
    try (KeyOutput<VelocityStreamable> velocity =
        board.advertise(ChannelKey.of("drive/velocity", VelocityStreamable.class), "stick");
        KeyOutput<TargetStreamable> target =
            board.advertise(ChannelKey.of("navigation/target", TargetStreamable.class), "test")) {
      await(ChannelKey.of("odometry", OdometryStreamable.class), m -> m.forward() > 0.15,
          () -> velocity.push(new VelocityStreamable(0.2, 0, 0)));
      await("odometry", OdometryStreamable.class, m -> m.forward() == 0);
      PoseStreamable here = await("localisation/pose", PoseStreamable.class, any -> true);
      target.push(new TargetStreamable("map", here.x() - 0.5, here.y(), here.heading()));
      await("odometry", OdometryStreamable.class, m -> m.forward() != 0 || m.turn() != 0);
    }
  }
}
