package org.robotui.uic.topics.internal;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.Input.Candidate;
import org.robotui.api.port.RawMessage;
import org.robotui.api.port.SourceId;
import org.robotui.data.array.Bytes;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.topics.internal.model.FakeGraph;
import org.robotui.uic.topics.internal.model.Fields;
import org.robotui.uic.topics.internal.model.Key;
import org.robotui.uic.topics.internal.model.TopicsModel;
import org.robotui.uic.topics.internal.view.Stage;
import org.robotui.uic.topics.internal.view.TopicsSurface;

/** Shows the view in its states side by side, for a person to look at: {@code Gallery dark|light page}. */
final class Gallery {
  private static final SourceId ODOM = new SourceId("base", "odom");
  private static final String TWIST = """
      # This expresses velocity in free space broken into its linear and angular parts.
      Vector3  linear
      Vector3  angular

      ================================================================================
      MSG: geometry_msgs/Vector3
      # This represents a vector in free space.
      float64 x
      float64 y
      float64 z
      """;

  private final GalleryWindow window;
  private final Theme theme;
  private long now = System.nanoTime() - 3_000_000_000L;

  private Gallery(GalleryWindow window, Theme theme) {
    this.window = window;
    this.theme = theme;
  }

  public static void main(String[] arguments) {
    Display display = new Display();
    Theme theme = Themes.of(display, arguments[0]);
    GalleryWindow window = new GalleryWindow(display, theme.color(Role.LINE));
    Gallery gallery = new Gallery(window, theme);
    window.open();
    if (arguments[1].equals("1")) {
      gallery.first();
    } else {
      gallery.second();
    }
    window.show();
  }

  private void first() {
    cell(0, 0, 1120, 560, Gallery::typical, (stage, model) -> {
      stage.select("/odom");
      stage.open();
      List.of("/odom", "/scan", "/camera/image_raw")
          .forEach(t -> model.measure(new Key("base", Kind.TOPIC, t), true, 10));
    });
    cell(1126, 0, 474, 560, Gallery::typical, (stage, model) -> {
      stage.select("/odom");
      stage.open();
    });
    cell(0, 566, 796, 434, Gallery::typical, (stage, model) -> {
      stage.select("/cmd_vel");
      stage.publish();
    });
    cell(802, 566, 798, 434, Gallery::typical, (stage, model) -> stage.select("/cmd_vel"));
  }

  private void second() {
    cell(0, 0, 796, 330, Gallery::typical, (stage, model) -> {
      stage.section(Kind.NODE);
      stage.select(Kind.NODE, "/base_driver");
    });
    cell(802, 0, 798, 330, Gallery::typical, (stage, model) -> {
      stage.select("/tf");
      stage.open();
    });
    cell(0, 336, 796, 330, c -> {
      typical(c);
      c.authority().take(FakeAuthority.ANNA, false);
    }, (stage, model) -> {
      stage.select("/cmd_vel");
      stage.publish();
      model.tick(System.nanoTime() - 2_900_000_000L, new TopicsOptions(Duration.ofSeconds(2), 10, 100));
      stage.publishOnce();
    });
    cell(802, 336, 798, 330, c -> c.robots(List.of(FakeGraph.large().robot("base"))),
        (stage, model) -> stage.filter("robot19 topic07"));
    cell(0, 672, 520, 328, c -> {}, (stage, model) -> {});
    cell(526, 672, 530, 328, c -> {
      FakeGraph graph = new FakeGraph();
      graph.fail(Optional.of("localhost:11311 refuses the connection"));
      c.robots(List.of(graph.robot("base")));
    }, (stage, model) -> {});
    cell(1062, 672, 538, 328, Gallery::typical, (stage, model) -> stage.section(Kind.ACTION));
  }

  private static void typical(FakeUicContext context) {
    FakeGraph graph = new FakeGraph()
        .add(Kind.TOPIC, "/camera/camera_info", "sensor_msgs/CameraInfo")
        .add(Kind.TOPIC, "/camera/image_raw", "sensor_msgs/Image")
        .add(Kind.TOPIC, "/cmd_vel", "geometry_msgs/Twist")
        .add(Kind.TOPIC, "/diagnostics", "diagnostic_msgs/DiagnosticArray")
        .add(Kind.TOPIC, "/imu/data", "sensor_msgs/Imu").add(Kind.TOPIC, "/joint_states", "sensor_msgs/JointState")
        .add(Kind.TOPIC, "/map", "nav_msgs/OccupancyGrid").add(Kind.TOPIC, "/odom", "nav_msgs/Odometry")
        .add(Kind.TOPIC, "/rosout", "rosgraph_msgs/Log").add(Kind.TOPIC, "/scan", "sensor_msgs/LaserScan")
        .add(Kind.TOPIC, "/tf", "tf2_msgs/TFMessage")
        .add(Kind.NODE, "/amcl", "").add(Kind.NODE, "/base_driver", "").add(Kind.NODE, "/move_base", "")
        .add(Kind.NODE, "/rosout", "")
        .add(Kind.SERVICE, "/move_base/clear_costmaps", "").add(Kind.SERVICE, "/static_map", "")
        .describe(Kind.TOPIC, "/cmd_vel", "geometry_msgs/Twist",
            facts("type", "geometry_msgs/Twist", "publishers", "/move_base", "subscribers", "/base_driver, /amcl"),
            TWIST, Optional.of(FakeGraph.twist()))
        .describe(Kind.TOPIC, "/odom", "nav_msgs/Odometry",
            facts("type", "nav_msgs/Odometry", "publishers", "/base_driver", "subscribers", "/amcl, /move_base"), "",
            Optional.empty())
        .describe(Kind.TOPIC, "/tf", "tf2_msgs/TFMessage", facts("type", "tf2_msgs/TFMessage"), "", Optional.empty())
        .describe(Kind.NODE, "/base_driver", "",
            facts("address", "http://keira:41233/", "publishes", "/odom, /scan, /tf, /diagnostics",
                "subscribes", "/cmd_vel", "services", "none"),
            "", Optional.empty());
    context.robots(List.of(graph.robot("base")));
    context.input(TopicsPorts.ALL).candidates(List.of(new Candidate(ODOM, "Odometry"),
        new Candidate(new SourceId("base", "scan"), "LaserScan"),
        new Candidate(new SourceId("base", "camera/image_raw"), "Image"),
        new Candidate(new SourceId("base", "imu/data"), "Imu"), new Candidate(new SourceId("base", "map"), "GridMap")));
  }

  private static Map<String, String> facts(String... pairs) {
    Map<String, String> facts = new LinkedHashMap<>();
    for (int i = 0; i < pairs.length; i += 2) {
      facts.put(pairs[i], pairs[i + 1]);
    }
    return facts;
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare,
      BiConsumer<Stage, TopicsModel> act) {
    FakeUicContext context = new FakeUicContext("topics", TopicsOptions.schema());
    prepare.accept(context);
    Composite part = window.cell(x, y, width, height);
    TopicsModel model = new TopicsModel(context);
    TopicsSurface surface = new TopicsSurface(part, UiContext.of(theme, text -> {}), model,
        () -> TopicsOptions.of(context.settings().current()),
        context.ruic().name(), new SubjectMenu(context.ruic(), theme, Runnable::run));
    part.layout(true, true);
    run(context, model, surface, 1);
    Stage stage = new Stage(surface);
    act.accept(stage, model);
    run(context, model, surface, 40);
  }

  private void run(FakeUicContext context, TopicsModel model, TopicsSurface surface, int ticks) {
    long at = now;
    for (int i = 0; i < ticks; i++) {
      at += 50_000_000L;
      put(context, ODOM, at, 712, i);
      put(context, new SourceId("base", "scan"), at, 2904, i);
      put(context, new SourceId("base", "camera/image_raw"), at + i % 3 * 4_000_000L, 230_456, i);
      model.seen(at);
      model.tick(at, TopicsOptions.of(context.settings().current()));
    }
    surface.refresh();
  }

  private static void put(FakeUicContext context, SourceId source, long at, int size, int i) {
    if (context.input(TopicsPorts.ALL).chosen().contains(source)) {
      Fields fields = Fields.odometry(1.24 + 0.01 * i);
      RawMessage raw =
          new RawMessage("nav_msgs/Odometry", "ros1", Bytes.of(new byte[size]), bytes -> Optional.of(fields));
      context.input(TopicsPorts.ALL).put(source, fields, at, Optional.empty(), Optional.of(raw));
    }
  }
}
