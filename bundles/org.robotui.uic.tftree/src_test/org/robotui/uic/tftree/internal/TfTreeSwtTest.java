package org.robotui.uic.tftree.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.testkit.Controls;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.diagram.Diagram;
import org.robotui.ui.diagram.DiagramCanvas;
import org.robotui.ui.diagram.DiagramSaver;
import org.robotui.uic.tftree.internal.model.Ask;
import org.robotui.uic.tftree.internal.model.TfTreeModel;
import org.robotui.uic.tftree.internal.model.Trees;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class TfTreeSwtTest {
  private final Theme theme = Themes.dark(TestDisplay.get());
  private final Shell shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
  private final FakeUicContext context = new FakeUicContext("tftree", new TfTreeType().descriptor().schema());
  private TfTreeUic uic;
  private Control view;
  private String note = "";

  @BeforeEach
  void open() {
    shell.setLayout(new FillLayout());
    shell.setSize(900, 500);
    context.frames(Trees.frames(Trees.base()));
    uic = new TfTreeUic(context);
    view = uic.createControl(shell, UiContext.of(theme, text -> note = text));
    shell.open();
    shell.layout(true, true);
    tick(0);
  }

  @AfterEach
  void close() {
    uic.close();
    shell.dispose();
    theme.dispose();
  }

  private void tick(long after) {
    uic.tick(Trees.NOW + after);
    uic.refresh();
    view.update();
  }

  @Test
  void theTitleCountsAndTheFormIsKept() {
    assertEquals("13 frames", note);
    uic.ask(uic.asked().drawn(false).in(new Ask.Reference.Pinned(Trees.id("odom"))));
    assertEquals("list", context.settings().current().text(TfTreeType.FORM));
    assertEquals("Keira:odom", context.settings().current().text(TfTreeType.REFERENCE));
    try (TfTreeUic again = new TfTreeUic(context)) {
      assertEquals(new Ask.Reference.Pinned(Trees.id("odom")), again.asked().reference());
    }
    tick(1);
  }

  @Test
  void aClickOnABoxSelectsItsFrameAndEscLetsGo() {
    PaintedCanvas canvas =
        Controls.all(shell, PaintedCanvas.class).stream().filter(c -> c.getSize().y > 200).findFirst().orElseThrow();
    Optional<int[]> hit = Optional.empty();
    for (int x = 20; x < canvas.getSize().x && hit.isEmpty(); x += 10) {
      press(canvas, x, canvas.getSize().y / 2);
      hit = uic.asked().selected().isPresent() ? Optional.of(new int[]{x}) : Optional.empty();
    }
    assertTrue(uic.asked().selected().isPresent(), "a row of boxes crosses the middle");
    tick(1);
    Event esc = new Event();
    esc.keyCode = SWT.ESC;
    canvas.notifyListeners(SWT.KeyDown, esc);
    assertFalse(uic.asked().selected().isPresent());
  }

  @Test
  void theDrawingIsSavedAsPictureAndAsSvg(@TempDir Path folder) throws Exception {
    DiagramCanvas canvas = new DiagramCanvas(shell, theme);
    shell.layout();
    canvas.show(drawing());
    Path png = folder.resolve("t.png");
    assertEquals(Optional.empty(), DiagramSaver.write(canvas, theme, png));
    assertTrue(Files.size(png) > 1000);
    Path svg = folder.resolve("t.svg");
    assertEquals(Optional.empty(), DiagramSaver.write(canvas, theme, svg));
    assertTrue(Files.readString(svg).contains("camera_depth_optical_frame"));
    assertTrue(DiagramSaver.write(canvas, theme, folder.resolve("none/t.svg")).orElseThrow()
        .startsWith("The drawing was not saved"));
  }

  private Diagram drawing() {
    TfTreeModel model = new TfTreeModel(context);
    model.tick(Trees.NOW, 3);
    return model.look().drawing();
  }

  private static void press(Control control, int x, int y) {
    for (int type : new int[]{SWT.MouseDown, SWT.MouseUp}) {
      Event event = new Event();
      event.button = 1;
      event.x = x;
      event.y = y;
      control.notifyListeners(type, event);
    }
  }
}
