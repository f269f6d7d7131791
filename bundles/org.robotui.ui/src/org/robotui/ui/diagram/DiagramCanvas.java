package org.robotui.ui.diagram;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.Function;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Image;
import org.eclipse.swt.graphics.ImageData;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.ViewKey;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.scene.SceneHands;
import org.robotui.ui.scene.Viewport;

/**
 * Shows a diagram: drag and arrows move it, the wheel, plus and minus zoom, 0, Home and a double click beside all boxes
 * show all; a click selects a box and lets all fade that it is not wired to. Paints only what is in sight. Display
 * thread only.
 */
public final class DiagramCanvas {
  private static final int MOST_PIXELS = 8000;

  private record Message(Health health, String title, String sentence) {}

  private final PaintedCanvas canvas;
  private final Theme theme;
  private final DiagramPainter painter;
  private final StateView stateView;
  private final DiagramEye eye = new DiagramEye();
  private Consumer<Optional<Object>> selecting = key -> {};
  private Consumer<Box> opening = box -> {};
  private Function<Box, String> hints = box -> "";
  private Diagram diagram = Diagram.EMPTY;
  private Optional<Object> selected = Optional.empty();
  private Set<Object> lit = Set.of();
  private Message message = new Message(Health.NONE, "", "");
  private InputState state = new InputState.Live(0, 0);

  /**
   * An empty canvas.
   *
   * @param parent the parent
   * @param theme colours and fonts
   */
  public DiagramCanvas(Composite parent, Theme theme) {
    this.theme = theme;
    painter = new DiagramPainter(theme);
    stateView = new StateView(theme);
    canvas = new PaintedCanvas(parent, theme, this::paint);
    new SceneHands(canvas, new Hands());
    canvas.addListener(SWT.MouseMove, this::hint);
    canvas.addListener(SWT.MouseDoubleClick, e -> at(e).ifPresent(opening));
    canvas.addListener(SWT.KeyDown, e -> {
      if (e.keyCode == SWT.ESC) {
        choose(Optional.empty());
      } else if (e.keyCode == SWT.CR || e.keyCode == SWT.KEYPAD_CR) {
        selected.flatMap(diagram::find).ifPresent(opening);
      }
    });
  }

  /**
   * What stands in the layout.
   *
   * @return the control
   */
  public Control control() {
    return canvas;
  }

  /**
   * What is done when the user selects a box, or none.
   *
   * @param action is given its key
   * @return this
   */
  public DiagramCanvas onSelect(Consumer<Optional<Object>> action) {
    selecting = action;
    return this;
  }

  /**
   * What is done at a double click on a box, or Enter.
   *
   * @param action is given the box
   * @return this
   */
  public DiagramCanvas onOpen(Consumer<Box> action) {
    opening = action;
    return this;
  }

  /**
   * Gives boxes a context menu; the box is selected by that.
   *
   * @param fill is given the menu and the box; what it leaves empty is not opened
   * @return this
   */
  public DiagramCanvas onMenu(BiConsumer<PopupMenu, Box> fill) {
    canvas.addListener(SWT.MenuDetect, e -> meant(e).ifPresent(box -> {
      choose(Optional.of(box.key()));
      PopupMenu menu = new PopupMenu(canvas);
      fill.accept(menu, box);
      menu.open(new Point(e.x, e.y));
    }));
    return this;
  }

  /**
   * What Ctrl+F does.
   *
   * @param find has the user type what is searched for
   * @return this
   */
  public DiagramCanvas onFind(Runnable find) {
    canvas.addListener(SWT.KeyDown, e -> {
      if (e.keyCode == 'f' && (e.stateMask & SWT.MOD1) != 0) {
        find.run();
      }
    });
    return this;
  }

  /**
   * The keys of a view that draws a diagram.
   *
   * @param whole what is drawn
   * @param enter what the Enter key does with a selected box
   * @return the keys of this canvas and that which finds
   */
  public static List<ViewKey> keys(String whole, String enter) {
    return List.of(new ViewKey("0, Home", "Show the whole " + whole), new ViewKey("+, -", "Zoom"),
        new ViewKey("Arrows", "Move"), new ViewKey("Enter", enter), new ViewKey("Ctrl+F", "Filter"),
        new ViewKey("Esc", "Clear the selection"));
  }

  /** By key the selected box, by mouse the one below the pointer. */
  private Optional<Box> meant(Event menuDetect) {
    Point at = canvas.toControl(menuDetect.x, menuDetect.y);
    return menuDetect.detail == SWT.MENU_KEYBOARD ? selected.flatMap(diagram::find)
        : diagram.at(eye.diagramX(at.x), eye.diagramY(at.y));
  }

  /**
   * What the tooltip of a box says.
   *
   * @param words of a box, empty for none
   * @return this
   */
  public DiagramCanvas hints(Function<Box, String> words) {
    hints = words;
    return this;
  }

  /**
   * Shows another diagram. Until the user moves it, all of it is seen; then what was in sight stays.
   *
   * @param next the diagram
   */
  public void show(Diagram next) {
    if (diagram != next) {
      diagram = next;
      light();
      canvas.redraw();
    }
  }

  /**
   * Where it stands for an input: what its state has to say is painted in place of the diagram, or over it.
   *
   * @param next the state
   */
  public void state(InputState next) {
    if (!state.equals(next)) {
      state = next;
      canvas.redraw();
    }
  }

  /**
   * What stands in place of the diagram while it is empty.
   *
   * @param health its dot
   * @param title a few words
   * @param sentence what is so and what would help
   */
  public void message(Health health, String title, String sentence) {
    Message next = new Message(health, title, sentence);
    if (!next.equals(message)) {
      message = next;
      canvas.redraw();
    }
  }

  /**
   * The diagram.
   *
   * @return what is shown
   */
  public Diagram diagram() {
    return diagram;
  }

  /**
   * Selects a box without telling, and brings it into sight.
   *
   * @param key of the box, none for nothing
   */
  public void select(Optional<?> key) {
    Optional<Object> next = key.map(k -> k);
    if (!selected.equals(next)) {
      selected = next;
      light();
      next.flatMap(diagram::find).filter(box -> eye.moved())
          .ifPresent(box -> eye.reveal(box, canvas.getSize().x, canvas.getSize().y));
      canvas.redraw();
    }
  }

  /** Shows all. */
  public void fit() {
    eye.fit();
    canvas.redraw();
  }

  /**
   * All of the diagram as a picture, at a zoom of 1 or as large as is sensible.
   *
   * @return its pixels
   */
  public ImageData picture() {
    int margin = 16;
    double zoom = Math.min(1, (MOST_PIXELS - 2.0 * margin) / Math.max(1, Math.max(diagram.width(), diagram.height())));
    int width = (int) Math.ceil(diagram.width() * zoom) + 2 * margin;
    int height = (int) Math.ceil(diagram.height() * zoom) + 2 * margin;
    Image image = new Image(canvas.getDisplay(), width, height);
    GC gc = new GC(image);
    Rectangle area = new Rectangle(0, 0, width, height);
    gc.setBackground(theme.color(Role.PANEL));
    gc.fillRectangle(area);
    gc.setAntialias(SWT.ON);
    DiagramEye all = new DiagramEye();
    all.fit();
    all.settle(diagram, width, height);
    painter.paint(gc, area, diagram, all, Optional.empty(), Set.of());
    gc.dispose();
    ImageData data = image.getImageData(100);
    image.dispose();
    return data;
  }

  private void light() {
    lit = selected.filter(key -> diagram.find(key).isPresent()).map(diagram::around).orElse(Set.of());
  }

  private void paint(GC gc, Rectangle area) {
    if (!StateView.showsContent(state)) {
      stateView.paint(gc, area, state);
      return;
    }
    if (diagram.boxes().isEmpty()) {
      if (!message.title().isEmpty()) {
        stateView.message(gc, area, message.health(), message.title(), message.sentence());
      }
      return;
    }
    eye.settle(diagram, area.width, area.height);
    painter.paint(gc, area, diagram, eye, selected, lit);
    stateView.paint(gc, area, state);
  }

  private Optional<Box> at(Event event) {
    return diagram.at(eye.diagramX(event.x), eye.diagramY(event.y));
  }

  private void hint(Event event) {
    String words = at(event).map(hints).orElse("");
    String shown = words.isEmpty() ? null : words.replace("&", "&&");
    if (!Objects.equals(shown, canvas.getToolTipText())) {
      canvas.setToolTipText(shown);
    }
  }

  private void choose(Optional<Object> key) {
    if (!selected.equals(key)) {
      select(key);
      selecting.accept(key);
    }
  }

  /** What the hands move. */
  private final class Hands implements SceneHands.Held {
    @Override
    public Viewport viewport() {
      return new Viewport(0, 0, 1, canvas.getSize().x, canvas.getSize().y);
    }

    @Override
    public void pan(double dx, double dy) {
      eye.pan(dx, dy);
      canvas.redraw();
    }

    @Override
    public void zoom(double x, double y, double factor) {
      eye.zoom(x, y, factor);
      canvas.redraw();
    }

    @Override
    public void fit() {
      DiagramCanvas.this.fit();
    }

    /** A press on a group moves the diagram, as there may be nothing else in sight. */
    @Override
    public boolean press(int x, int y) {
      Optional<Box> hit = diagram.at(eye.diagramX(x), eye.diagramY(y));
      choose(hit.map(Box::key));
      return hit.filter(box -> box.form() != Box.Form.GROUP).isPresent();
    }
  }
}
