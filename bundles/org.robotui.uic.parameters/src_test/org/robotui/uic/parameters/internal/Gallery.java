package org.robotui.uic.parameters.internal;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.port.Browser.Choice;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.uic.parameters.internal.model.FakeRobot;
import org.robotui.uic.parameters.internal.model.Key;
import org.robotui.uic.parameters.internal.model.ParametersModel;
import org.robotui.uic.parameters.internal.view.ParametersSurface;
import org.robotui.uic.parameters.internal.view.Stage;

/** Shows the view in its states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    cell(0, 0, 796, 496, Gallery::typical, (stage, model) -> {
      open(model);
      stage.settle();
      model.set(new Key("base", "/move_base/max_vel_x"), 0.6);
      stage.settle();
      stage.edit("/move_base/footprint", "[[0.2, 0.1], [0.2, -0.1");
    });
    cell(802, 0, 798, 496, Gallery::typical, (stage, model) -> {
      model.tuning(true);
      model.tune(Optional.of(new Key("base", "/camera_driver")));
      stage.settle();
      stage.type("exposure", "900");
    });
    cell(0, 502, 500, 498, c -> {
      typical(c);
      c.authority().take(FakeAuthority.ANNA, false);
    }, (stage, model) -> {
      open(model);
      model.set(new Key("base", "/use_sim_time"), true);
    });
    cell(506, 502, 540, 498, Gallery::typical, (stage, model) -> {
      model.tuning(true);
      model.tune(Optional.of(new Key("base", "/camera_driver")));
    });
    cell(1052, 502, 548, 160, c -> {}, (stage, model) -> {});
    cell(1052, 668, 548, 160, c -> {
      FakeRobot robot = new FakeRobot();
      robot.fail(Optional.of("localhost:11311 refuses the connection"));
      c.robots(List.of(robot.robot("base")));
    }, (stage, model) -> {});
    cell(1052, 834, 548, 166, Gallery::typical, (stage, model) -> stage.filter("nothing like this"));
  }

  private static void open(ParametersModel model) {
    List.of("/camera_driver", "/move_base", "/move_base/controller")
        .forEach(name -> model.open(new Key("base", name), true));
  }

  private static void typical(FakeUicContext context) {
    FakeRobot robot = new FakeRobot().with("/camera_driver/frame_id", "camera_optical_frame")
        .with("/camera_driver/exposure", 120L)
        .with("/move_base/max_vel_x", 0.4)
        .with("/move_base/footprint", List.of(List.of(0.2, 0.1), List.of(0.2, -0.1), List.of(-0.2, 0.0)))
        .with("/move_base/controller/gains", Map.of("p", 1.2)).with("/move_base/controller/enabled", true)
        .with("/robot_description", "<?xml version=\"1.0\"?>\n<robot name=\"keira\">").with("/rosdistro", "noetic\n")
        .with("/run_id", "5b1a").with("/use_sim_time", false).with("/amcl/min_particles", 100L)
        .with("/amcl/max_particles", 500L)
        .server("/camera_driver",
            FakeRobot.plain("auto_exposure", "", false, true, "Lets the camera choose the exposure"),
            FakeRobot.whole("exposure", "", 120, 120, 1, 500, "Exposure time in units of 100 microseconds"),
            FakeRobot.number("gain", "", 0.62, 0.5, 0, 1, "Gain of the sensor"),
            FakeRobot.choice("mode", 1, 1, "Resolution and rate", new Choice("VGA", 0L, "640 x 480 at 60 Hz"),
                new Choice("HD", 1L, "1280 x 720 at 30 Hz"), new Choice("Full", 2L, "1920 x 1080 at 15 Hz")),
            FakeRobot.plain("frame_id", "Output", "camera_optical_frame", "camera", "Frame of the pictures"),
            FakeRobot.number("time_offset", "Output", 0, 0, -1e308, 1e308, "Seconds added to each stamp"))
        .server("/move_base/DWAPlanner", FakeRobot.number("max_vel_x", "", 0.4, 0.55, 0, 1, ""))
        .server("/move_base/local_costmap");
    context.robots(List.of(robot.robot("base")));
  }

  private void cell(int x, int y, int width, int height, Consumer<FakeUicContext> prepare,
      BiConsumer<Stage, ParametersModel> act) {
    FakeUicContext context = new FakeUicContext("parameters", ParametersOptions.schema());
    prepare.accept(context);
    Composite part = window.cell(x, y, width, height);
    ParametersModel model = new ParametersModel(context);
    ParametersSurface surface = new ParametersSurface(part, UiContext.of(theme, text -> {}), model);
    part.layout(true, true);
    Stage stage = new Stage(surface, model, () -> ParametersOptions.of(context.settings().current()));
    stage.settle();
    act.accept(stage, model);
    stage.settle();
  }
}
