package org.robotui.uic.parameters.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Controls;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewItem;
import org.robotui.uic.parameters.internal.model.FakeRobot;
import org.robotui.uic.parameters.internal.model.Key;
import org.robotui.uic.parameters.internal.model.ParametersModel;
import org.robotui.uic.parameters.internal.view.ParametersSurface;
import org.robotui.uic.parameters.internal.view.Stage;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class ParametersSwtTest {
  private static final long PATIENCE_NANOS = 30_000_000_000L;

  private final FakeUicContext context = new FakeUicContext("parameters", ParametersOptions.schema());
  private final ParametersModel model = new ParametersModel(context);
  private final FakeRobot robot =
      new FakeRobot().with("/speed", 0.5).with("/gains", List.of(1.0, 2.0)).with("/flag", true)
          .server("/camera", FakeRobot.whole("exposure", "", 120, 120, 0, 500, "help"),
              FakeRobot.plain("frame", "Output", "a", "b", ""));
  private Display display;
  private Theme theme;
  private Shell shell;
  private Stage stage;
  private String note = "";

  @BeforeEach
  void open() {
    display = TestDisplay.get();
    theme = Themes.dark(display);
    shell = new Shell(display, SWT.NO_TRIM);
    shell.setLayout(new FillLayout());
    shell.setSize(800, 500);
    ParametersSurface surface = new ParametersSurface(shell, UiContext.of(theme, text -> note = text), model);
    stage = new Stage(surface, model, () -> ParametersOptions.of(context.settings().current()));
    shell.open();
    context.robots(List.of(robot.robot("base")));
    wait(() -> model.look().rows().stream().filter(row -> row.value().isPresent()).count() == 3);
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void aValueIsEditedWhereItStands() {
    stage.edit("/gains", "[3, 4.5]");
    assertTrue(stage.editor().isPresent());
    stage.enter();
    wait(() -> List.of(3.0, 4.5).equals(robot.value("/gains")));
    assertTrue(stage.editor().isEmpty());
    wait(() -> note.equals("1 changed"));
  }

  @Test
  void whatTheSearchOfTheWindowFindsIsShownAlone() {
    ParametersUic view = new ParametersUic(context);
    Composite parent = new Composite(shell, SWT.NONE);
    parent.setLayout(new FillLayout());
    view.createControl(parent, UiContext.of(theme, text -> {}));
    shell.layout();
    wait(() -> view.tick(System.nanoTime()) && view.items().size() == 3);
    assertEquals(List.of("/flag", "/gains", "/speed"), view.items().stream().map(ViewItem::name).toList());

    view.items().getLast().show().run();
    wait(() -> {
      view.tick(System.nanoTime());
      view.refresh();
      return Controls.all(parent, Text.class).stream().anyMatch(field -> field.getText().equals("/speed"));
    });
  }

  @Test
  void whatCannotBeReadIsSaidAndNotSet() {
    stage.edit("/speed", "fast");
    stage.enter();
    wait(() -> model.look().told().text().equals("'fast' is no number"));
    assertTrue(stage.editor().isPresent(), "it can be mended");
    assertEquals(0.5, robot.value("/speed"));
  }

  @Test
  void aTextOfSeveralLinesKeepsThem() {
    robot.with("/description", "one\ntwo");
    model.refresh();
    wait(() -> model.look().rows().stream().filter(row -> row.value().isPresent()).count() == 4);
    stage.edit("/description", "one\ntwo\nthree");
    stage.enter();
    assertEquals("one\ntwo", robot.value("/description"), "Enter begins a line");
    stage.controlEnter();
    wait(() -> "one\ntwo\nthree".equals(robot.value("/description")));
  }

  @Test
  void wordsTypedForOneLeafHideNothingOnTheOther() {
    stage.leaf(true);
    stage.filter("camera");
    stage.leaf(true);
    assertEquals("camera", stage.words(), "the same leaf keeps them");
    stage.leaf(false);
    assertEquals("", stage.words());
    wait(() -> model.look().filter().isEmpty() && !model.look().rows().isEmpty());
  }

  @Test
  void anEditedFieldOfAProgramIsSent() {
    tune();
    stage.type("exposure", "200");
    wait(() -> robot.sent().contains(Map.of("exposure", 200L)));
    stage.type("exposure", "900");
    wait(() -> model.tuner().orElseThrow().panel().knobs().getFirst().problem().isPresent());
    assertEquals(1, robot.sent().size());
  }

  @Test
  void aDraggedSliderSetsAndTheFieldFollows() {
    tune();
    stage.drag("exposure", 0.5);
    wait(() -> !robot.sent().isEmpty());
    long sent = (Long) robot.sent().getLast().get("exposure");
    assertEquals(250, sent, 5);
    wait(() -> stage.fieldText("exposure").equals(Optional.of(Long.toString(sent))));
  }

  private void tune() {
    model.tuning(true);
    model.tune(Optional.of(new Key("base", "/camera")));
    wait(() -> stage.fieldText("exposure").equals(Optional.of("120")));
  }

  private void wait(BooleanSupplier done) {
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!done.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "what is waited for did not come");
      stage.settle();
    }
  }
}
