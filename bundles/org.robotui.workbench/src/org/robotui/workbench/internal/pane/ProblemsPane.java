package org.robotui.workbench.internal.pane;

import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.ScrolledComposite;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.graphics.TextLayout;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.host.Problem;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.HealthDot;
import org.robotui.ui.Icon;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.QuietButton;

/** What is wrong with a configuration: where, and what to write. Display thread only. */
public final class ProblemsPane extends Composite {
  private static final int MOST_HEIGHT = 240;
  private static final int GAP = 8;

  private final Theme theme;
  private final List<Problem> problems;

  /**
   * Makes the panel.
   *
   * @param parent the parent
   * @param theme colours and fonts
   * @param problems at least one
   * @param reload reads the file again
   * @param close takes the panel away
   */
  public ProblemsPane(Composite parent, Theme theme, List<Problem> problems, Runnable reload, Runnable close) {
    super(parent, SWT.NONE);
    this.theme = theme;
    this.problems = problems;
    setBackground(theme.color(Role.TITLE));
    GridLayout layout = new GridLayout(3, false);
    layout.marginWidth = Theme.EDGE;
    layout.marginHeight = Theme.STEP;
    layout.verticalSpacing = Theme.STEP;
    setLayout(layout);
    head(reload, close);
    list();
    addPaintListener(e -> {
      e.gc.setForeground(theme.color(Role.LINE));
      e.gc.drawLine(0, getSize().y - 1, getSize().x, getSize().y - 1);
    });
  }

  private void head(Runnable reload, Runnable close) {
    long errors = problems.stream().filter(p -> p.severity() == Problem.Severity.ERROR).count();
    boolean whole = problems.stream().allMatch(p -> p.line() == 0);
    String text = errors == 0 ? "The configuration is usable, but look at this"
        : whole ? "A file cannot be opened" : "The configuration cannot be used as written";
    ShortenedLabel title = new ShortenedLabel(this, theme, Face.TITLE, Role.TEXT, text);
    title.setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    new QuietButton(this, theme, reload).icon(Icon.RESTART).text("Read again").hint("Read the configuration again");
    new QuietButton(this, theme, close).icon(Icon.CLOSE).hint("Close");
  }

  private void list() {
    ScrolledComposite scroller = new ScrolledComposite(this, SWT.V_SCROLL);
    scroller.setBackground(theme.color(Role.TITLE));
    scroller.setExpandHorizontal(true);
    scroller.setExpandVertical(true);
    PaintedCanvas canvas = new PaintedCanvas(scroller, SWT.NONE, theme, Role.TITLE, this::paint);
    scroller.setContent(canvas);
    GridData data = new GridData(SWT.FILL, SWT.FILL, true, true, 3, 1);
    scroller.setLayoutData(data);
    scroller.addListener(SWT.Resize, e -> scroller.setMinHeight(heightAt(scroller.getClientArea().width)));
    data.heightHint = Math.min(MOST_HEIGHT, heightAt(700));
  }

  private int heightAt(int width) {
    int height = GAP;
    for (Problem problem : problems) {
      TextLayout text = text(problem, width);
      height += text.getBounds().height + GAP;
      text.dispose();
    }
    return height;
  }

  private void paint(GC gc, Rectangle area) {
    int top = GAP / 2;
    for (Problem problem : problems) {
      boolean error = problem.severity() == Problem.Severity.ERROR;
      HealthDot.paint(gc, theme, error ? Health.BAD : Health.WARNING, 6, top + 9);
      TextLayout text = text(problem, area.width);
      gc.setForeground(theme.color(Role.TEXT));
      text.draw(gc, 20, top);
      top += text.getBounds().height + GAP;
      text.dispose();
    }
  }

  private TextLayout text(Problem problem, int width) {
    TextLayout text = new TextLayout(getDisplay());
    text.setFont(theme.font(Face.BODY));
    String place = problem.line() > 0 ? problem.file() + ":" + problem.line() + ":" + problem.column() : problem.file();
    text.setText(place + "  " + problem.message());
    text.setStyle(new org.eclipse.swt.graphics.TextStyle(
        theme.font(Face.FIGURES), theme.color(Role.ACCENT), null), 0, place.length() - 1);
    text.setWidth(Math.max(100, width - 20));
    return text;
  }
}
