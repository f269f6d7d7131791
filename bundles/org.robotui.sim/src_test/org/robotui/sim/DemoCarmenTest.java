package org.robotui.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.message.IpcRecordMaker;
import org.robotui.carmen.module.IpcModule;
import org.robotui.carmen.module.MessageSender;
import org.robotui.carmen.module.ModuleOptions;
import org.robotui.carmen.module.ParamClient;
import org.robotui.net.socket.HostPort;

/** The simulated robots as programs of CARMEN, seen by a module of ours. */
@Timeout(120)
class DemoCarmenTest {
  private static final long PATIENCE = 60;

  private final IpcForms forms = IpcForms.carmen();
  private final Map<String, BlockingQueue<IpcRecord>> heard = new ConcurrentHashMap<>();
  private Demo demo;
  private IpcModule module;

  private void start(String robot) throws IOException {
    demo = Demo.start(Options.parse(List.of("--robot", robot, "--speak", "carmen")));
    String central = demo.addresses().get("CENTRALHOST");
    int colon = central.indexOf(':');
    module = IpcModule.connect(
        new HostPort(central.substring(0, colon), Integer.parseInt(central.substring(colon + 1))), forms,
        ModuleOptions.of("test", Thread.ofPlatform().daemon().factory()));
  }

  @AfterEach
  void end() {
    module.close();
    demo.close();
  }

  private void listen(String message) throws IOException {
    if (!heard.containsKey(message)) {
      BlockingQueue<IpcRecord> queue = new LinkedBlockingQueue<>();
      heard.put(message, queue);
      module.subscribe(forms.get(message), 1, (record, body) -> {
        queue.add(record);
        return Optional.empty();
      });
    }
  }

  private IpcRecord await(String message, Predicate<IpcRecord> wanted) throws Exception {
    listen(message);
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE);
    while (true) {
      IpcRecord record = heard.get(message).poll(end - System.nanoTime(), TimeUnit.NANOSECONDS);
      assertNotNull(record, "no such " + message);
      if (wanted.test(record)) {
        return record;
      }
    }
  }

  private void tell(IpcRecordMaker message) throws IOException {
    assertTrue(module.sender(message.form()).command(message.build()));
  }

  @Test
  void natalieTellsWhatSheMeasuresAndIsDriven() throws Exception {
    start("natalie");
    IpcRecord laser = await("carmen_robot_frontlaser", any -> true);
    assertEquals(361, laser.floats("range").length);
    assertEquals(Math.PI, laser.record("config").number("fov"), 1e-6);
    assertEquals(16, await("carmen_base_sonar", any -> true).records("sonar_offsets").size());
    MessageSender velocities = module.sender(forms.get("carmen_robot_vel"));
    await("carmen_base_odometry", m -> {
      // again and again, as a robot stops that is told no more
      velocities.command(forms.get("carmen_robot_vel").make().number("tv", 0.2).build());
      return m.number("tv") > 0.15;
    });
    tell(forms.get("carmen_robot_vel").make());
    await("carmen_base_odometry", m -> m.number("tv") == 0);
  }

  @Test
  void natalieKnowsWhereSheIsAndGoesWhenTold() throws Exception {
    start("natalie");
    IpcRecord place = await("carmen_localize_globalpos", any -> true).record("globalpos");
    IpcRecord truth = await("carmen_simulator_truepos", any -> true).record("truepose");
    assertEquals(truth.number("x"), place.number("x"), 0.3);
    IpcRecord map = module.sender(forms.get("carmen_gridmap_request"))
        .query(forms.get("carmen_gridmap_request").make().build(), Duration.ofSeconds(PATIENCE)).toOptional()
        .orElseThrow().record();
    assertTrue(place.number("x") < map.record("config").whole("x_size") * map.record("config").number("resolution"));
    listen("carmen_navigator_plan");
    listen("carmen_navigator_status");
    tell(forms.get("carmen_navigator_set_goal_triplet").make().struct("goal", place.number("x") + 0.5,
        place.number("y"), 0));
    tell(forms.get("carmen_navigator_go").make());
    await("carmen_navigator_plan", m -> m.records("path").size() > 1);
    await("carmen_navigator_status", m -> m.whole("autonomous") == 1);
    tell(forms.get("carmen_navigator_stop").make());
    await("carmen_navigator_status", m -> m.whole("autonomous") == 0);
  }

  @Test
  void keiraHasBumpersAndParameters() throws Exception {
    start("keira");
    assertEquals(2, await("carmen_base_bumper", any -> true).octets("state").length);
    ParamClient params = new ParamClient(module, forms);
    assertEquals("off", params.all("robot").get("use_sonar"));
    assertEquals(Optional.of("0.1"), params.set("robot", "max_t_vel", "0.1"));
  }
}
