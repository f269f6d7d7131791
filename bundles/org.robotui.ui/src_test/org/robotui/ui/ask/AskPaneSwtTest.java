package org.robotui.ui.ask;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.Browser.Item;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.ui.control.QuietButton;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class AskPaneSwtTest {
  private static final SourceId GRAPH = new SourceId("base", "graph");
  private static final Item MOVE = new Item(Kind.ACTION, "/move_base", "move_base_msgs/MoveBaseAction");

  private final Display display = TestDisplay.get();
  private final FakeBrowser robot = new FakeBrowser();
  private final AskModel model = new AskModel(
      new Catalogue(() -> List.of(new BrowseInput.Robot(GRAPH, robot)), Runnable::run, Kind.ACTION),
      new Questions((entry, values, report) -> () -> {}));
  private Theme theme;
  private Shell shell;

  @BeforeEach
  void open() {
    theme = Themes.dark(display);
    shell = new Shell(display);
    shell.setLayout(new FillLayout());
    robot.items = List.of(MOVE);
    model.tick(System.nanoTime());
    model.choose(new Catalogue.Entry(GRAPH, MOVE));
    new AskPane(shell, UiContext.of(theme, note -> {}), model,
        new AskWords(Kind.ACTION, "actions", "Send goal", "Goal", "Result", true));
  }

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  @Test
  void sendingAndCancellingAreWholeHoweverNarrow() {
    shell.open();
    for (int width : new int[]{900, 500, 320, 420, 640, 1400}) {
      shell.setSize(width, 560);
      shell.layout(true, true);
      List<QuietButton> buttons = buttons(shell).stream().filter(b -> b.getParent().getChildren().length == 3).toList();
      assertEquals(2, buttons.size());
      buttons.forEach(button -> assertWhole(button, width));
    }
  }

  @Test
  void whatTheSearchOfTheWindowFindsIsChosen() {
    AskWords words = new AskWords(Kind.ACTION, "actions", "Send goal", "Goal", "Result", true);
    Catalogue.Entry other = new Catalogue.Entry(GRAPH, new Item(Kind.ACTION, "/dock", "Dock"));
    AskPane pane = new AskPane(shell, UiContext.of(theme, note -> {}), model, words);
    model.filter("move");

    pane.find(other);

    assertEquals("Action", words.label());
    assertEquals("", model.shown().filter());
    assertEquals(other, model.shown().detail().orElseThrow().entry());
  }

  private static void assertWhole(QuietButton button, int width) {
    Rectangle at = button.getBounds();
    int room = button.getParent().getClientArea().width;
    assertTrue(at.width > 40 && at.x + at.width <= room, () -> at + " in " + room + " of a view of " + width);
  }

  private static List<QuietButton> buttons(Composite parent) {
    List<QuietButton> found = new ArrayList<>();
    for (Control child : parent.getChildren()) {
      if (child instanceof QuietButton button) {
        found.add(button);
      } else if (child instanceof Composite inner) {
        found.addAll(buttons(inner));
      }
    }
    return found;
  }
}
