package org.robotui.uic.console.internal;

import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.eclipse.swt.widgets.Composite;
import org.robotui.testkit.FakeScripts;
import org.robotui.api.script.ScriptOutcome;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  private static final String LOOP = "while (value('base.battery_state').charge > 0.2) {\n  drive(0.3, 0, 2);\n}";

  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    cell(0, 0, 800, 400, Gallery::typical);
    cell(806, 0, 794, 400, (console, scripts) -> {});
    cell(0, 406, 360, 400, Gallery::typical);
    cell(366, 406, 500, 200, (console, scripts) -> {
      typical(console, scripts);
      console.hands().run(LOOP, List.of(LOOP));
    });
  }

  private static void typical(ConsoleUic console, FakeScripts scripts) {
    done(console, scripts, "value(\"base.odom\").pose.translation", "{x: 1.0342, y: -0.2211, z: 0}");
    done(console, scripts, "ports()",
        "[\"base.odom\", \"base.scan\", \"base.battery_state\", \"base.camera/image_raw\"]");
    console.hands().run("drive(0.3, 0, 2)", List.of());
    scripts.end(new ScriptOutcome.Failed("takeControl() first: nobody drives Natalie", "console", 1));
    console.hands().run("for (let i = 0; i < 2; i++) {\n  print(i);\n}", List.of());
    scripts.output.accept("0");
    scripts.output.accept("1");
    scripts.end(new ScriptOutcome.Done(Optional.empty(), ""));
  }

  private static void done(ConsoleUic console, FakeScripts scripts, String typed, String value) {
    console.hands().run(typed, List.of(typed));
    scripts.end(new ScriptOutcome.Done(Optional.of(value), value));
  }

  private void cell(int x, int y, int width, int height, BiConsumer<ConsoleUic, FakeScripts> fill) {
    FakeScripts scripts = new FakeScripts();
    ConsoleType type = new ConsoleType(scripts);
    FakeUicContext context = new FakeUicContext("console", type.schema());
    ConsoleUic console = new ConsoleUic(context, scripts);
    fill.accept(console, scripts);
    Composite part = window.cell(x, y, width, height);
    console.createControl(part, UiContext.of(theme, note -> {}));
    part.layout(true, true);
    console.refresh();
  }
}
