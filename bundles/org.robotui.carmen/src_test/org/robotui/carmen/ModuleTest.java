package org.robotui.carmen;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.carmen.central.CentralOptions;
import org.robotui.carmen.central.IpcCentral;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcForm;
import org.robotui.carmen.message.IpcForms;
import org.robotui.carmen.module.IpcAnswer;
import org.robotui.carmen.module.IpcModule;
import org.robotui.carmen.module.MessageSender;
import org.robotui.carmen.module.ModuleOptions;
import org.robotui.carmen.module.ParamClient;
import org.robotui.carmen.module.ParamDaemon;
import org.robotui.net.call.Outcome;
import org.robotui.net.socket.HostPort;

/** Modules at a central: through it, and directly. */
@Timeout(60)
class ModuleTest {

  private static final IpcForms FORMS = IpcForms.carmen();
  private static final IpcForm VELOCITY = FORMS.get("carmen_robot_vel");

  private static IpcCentral central(boolean direct) throws IOException {
    return new IpcCentral(new CentralOptions(Thread.ofPlatform().daemon().factory(), InetAddress.getLoopbackAddress(),
        0, direct));
  }

  private static IpcModule module(String name, IpcCentral central) throws IOException {
    return IpcModule.connect(new HostPort("127.0.0.1", central.port()), FORMS,
        ModuleOptions.of(name, Thread.ofPlatform().daemon().factory()));
  }

  private static void await(BooleanSupplier condition) throws InterruptedException {
    while (!condition.getAsBoolean()) {
      Thread.sleep(5);
    }
  }

  private static IpcRecord velocity(double tv) {
    return VELOCITY.make().number("tv", tv).number("rv", 0.1).text("host", "ui").build();
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void a_message_reaches_who_subscribes(boolean direct) throws Exception {
    List<IpcRecord> heard = new CopyOnWriteArrayList<>();
    try (IpcCentral central = central(direct);
        IpcModule robot = module("robot", central);
        IpcModule ui = module("ui", central)) {
      AutoCloseable subscription = robot.subscribe(VELOCITY, 100, (record, body) -> {
        heard.add(record);
        return Optional.empty();
      });
      await(() -> central.handlers().containsKey(VELOCITY.name()));
      assertEquals(List.of(VELOCITY.name()), ui.handled());
      assertEquals(direct, ui.isDirect());
      MessageSender sender = ui.sender(VELOCITY);
      for (int i = 0; i < 20; i++) {
        assertTrue(sender.publish(velocity(i)));
      }
      await(() -> heard.size() == 20);
      assertEquals(19, heard.getLast().number("tv"));
      subscription.close();
      await(() -> central.handlers().isEmpty());
    }
  }

  @ParameterizedTest
  @ValueSource(booleans = {false, true})
  void questions_are_answered(boolean direct) throws Exception {
    try (IpcCentral central = central(direct);
        IpcModule daemon = module("param_daemon", central);
        IpcModule listener = module("robot", central);
        IpcModule ui = module("ui", central)) {
      List<String> changes = new CopyOnWriteArrayList<>();
      listener.subscribe(FORMS.get("carmen_param_variable_change"), 100, (record, body) -> {
        changes.add(record.text("variable_name") + "=" + record.text("value"));
        return Optional.empty();
      });
      await(() -> central.handlers().containsKey("carmen_param_variable_change"));
      new ParamDaemon(daemon, FORMS, () -> 1.7e9, "robot",
          Map.of("robot", Map.of("max_t_vel", "0.6", "use_laser", "on")));
      await(() -> central.handlers().containsKey("carmen_param_set"));
      ParamClient params = new ParamClient(ui, FORMS);
      assertEquals(List.of("robot"), params.modules());
      assertEquals(Map.of("max_t_vel", "0.6", "use_laser", "on"), params.all("robot"));
      assertEquals(Optional.empty(), params.get("robot", "no_such"));
      assertEquals(Optional.of("0.3"), params.set("robot", "max_t_vel", "0.3"));
      assertEquals(Optional.of("0.3"), params.get("robot", "max_t_vel"));
      await(() -> changes.equals(List.of("max_t_vel=0.3")));
      Outcome<IpcAnswer> version = ui.sender(FORMS.get("carmen_param_query_version"))
          .query(FORMS.get("carmen_param_query_version").make().build(), Duration.ofSeconds(30));
      assertEquals(8, version.toOptional().orElseThrow().record().whole("minor"));
    }
  }

  @Test
  void of_a_message_whose_latest_is_wanted_older_ones_are_left_out() throws Exception {
    List<Double> heard = new CopyOnWriteArrayList<>();
    try (IpcCentral central = central(false);
        IpcModule robot = module("robot", central);
        IpcModule ui = module("ui", central)) {
      ui.subscribe(VELOCITY, 1, (record, body) -> {
        slowly();
        heard.add(record.number("tv"));
        return Optional.empty();
      });
      await(() -> central.handlers().containsKey(VELOCITY.name()));
      MessageSender sender = robot.sender(VELOCITY);
      for (int i = 0; i < 500; i++) {
        sender.publish(velocity(i));
      }
      await(() -> heard.contains(499.0));
      assertTrue(heard.size() < 500, () -> heard.size() + " were heard");
    }
  }

  private static void slowly() {
    try {
      Thread.sleep(2);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void what_a_message_consists_of_is_known_by_the_central() throws Exception {
    IpcForm own = IpcForm.of("mybot_arm", "{int,<double:1>,{float,string}}", "count angles tool{force name}");
    try (IpcCentral central = central(false);
        IpcModule robot = module("robot", central);
        IpcModule ui = module("ui", central)) {
      assertEquals(Optional.empty(), ui.look("mybot_arm"));
      robot.sender(own);
      IpcForm known = ui.look("mybot_arm").orElseThrow().form();
      assertEquals(own.format(), known.format());
      assertEquals("field3", known.fields().getLast().name());
      assertEquals("field2", known.fields().getLast().members().getLast().name());
    }
  }

  @Test
  void a_central_that_goes_ends_its_modules() throws Exception {
    IpcCentral central = central(false);
    try (IpcModule ui = module("ui", central)) {
      central.close();
      await(() -> ui.over().isPresent());
      assertThrows(IOException.class, ui::handled);
    }
  }

  @Test
  void what_is_no_central_is_refused() throws IOException {
    try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      Thread.ofPlatform().daemon().start(() -> {
        try {
          server.accept().getOutputStream().write("HTTP/1.1 400 Bad Request\r\n\r\n".getBytes());
        } catch (IOException e) {
          // the test is over
        }
      });
      IOException refused = assertThrows(IOException.class,
          () -> IpcModule.connect(new HostPort("127.0.0.1", server.getLocalPort()), FORMS,
              ModuleOptions.of("ui", Thread.ofPlatform().daemon().factory())));
      assertTrue(refused.getMessage().contains("no central of IPC"), refused::getMessage);
    }
  }
}
