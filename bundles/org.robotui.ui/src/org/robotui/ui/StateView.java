package org.robotui.ui;

import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.graphics.TextLayout;
import org.robotui.api.port.InputState;

/**
 * How the states of an input look, the same in all views. A view paints its content where {@link #showsContent} says
 * so, with {@link #contentAlpha}, and then has this painted over it. Display thread, but for the questions, which are
 * pure.
 */
public final class StateView {
  /** Letters of a sentence: what a robot calls things may have a million, which would take a second for every paint. */
  private static final int LONGEST = 1000;
  private static final int OPAQUE = 255;
  private static final int FADED = 90;
  private static final int GROUND_ALPHA = 236;
  private static final int LINE_WIDTH = 380;
  private static final int BANNER_HEIGHT = 22;

  private final Theme theme;

  /**
   * With a theme.
   *
   * @param theme colours and fonts
   */
  public StateView(Theme theme) {
    this.theme = theme;
  }

  /**
   * The dot of a state.
   *
   * @param state the state
   * @return its health
   */
  public static Health health(InputState state) {
    return switch (state) {
      case InputState.Unconnected u -> Health.NONE;
      case InputState.Waiting w -> Health.WAITING;
      case InputState.Live l -> Health.OK;
      case InputState.Stale s -> Health.STALE;
      case InputState.Failed f -> Health.BAD;
    };
  }

  /**
   * The word of a state.
   *
   * @param state the state
   * @return for example {@code stale 2.1 s}, or {@code lost for 12 s} where nothing newer can come
   */
  public static String word(InputState state) {
    return switch (state) {
      case InputState.Unconnected u -> "not connected";
      case InputState.Waiting w -> "waiting";
      case InputState.Live l -> l.rateHz() > 0 ? Figures.rate(l.rateHz()) : "live";
      case InputState.Stale s when s.refused() -> "refused";
      case InputState.Stale s -> s.lostSeconds().isPresent()
          ? "lost for " + Figures.age(s.lostSeconds().getAsDouble())
          : "stale " + Figures.age(s.ageSeconds());
      case InputState.Failed f -> "failed";
    };
  }

  /**
   * The word of old data, with what is to be known of it.
   *
   * @param state the state
   * @return that values are late needs no explanation; that nothing can come does:
   * {@code lost for 12 s: base.map: nobody publishes /map
   *     any more}
   */
  public static String sentence(InputState.Stale state) {
    return state.lostSeconds().isPresent() ? word(state) + "  \u00b7  " + state.explanation() : word(state);
  }

  /**
   * Whether content is to be painted.
   *
   * @param state the state
   * @return true where there is data, even old
   */
  public static boolean showsContent(InputState state) {
    return state instanceof InputState.Live || state instanceof InputState.Stale;
  }

  /**
   * How opaque content is to be painted.
   *
   * @param state the state
   * @return alpha as {@link GC#setAlpha} takes it
   */
  public static int contentAlpha(InputState state) {
    return state instanceof InputState.Stale ? FADED : OPAQUE;
  }

  /**
   * Paints what the state has to say: nothing where data is live, a banner where it is old, else dot, word and sentence
   * in the middle.
   *
   * @param gc where to paint
   * @param area the content's area
   * @param state the state
   */
  public void paint(GC gc, Rectangle area, InputState state) {
    switch (state) {
      case InputState.Live l -> {}
      case InputState.Stale s when s.refused() -> banner(gc, area, Health.WARNING, s.explanation());
      case InputState.Stale s -> banner(gc, area, Health.STALE, sentence(s));
      default -> message(gc, area, health(state), title(state), state.explanation());
    }
  }

  /**
   * The part of an area in which the banner of old data covers no rows: below the last one where there is room, else at
   * the lower edge, as the uppermost rows are those that are read first.
   *
   * @param area the area
   * @param rowsEnd where the last row ends that is seen
   * @return where to have {@link #paint} paint
   */
  public static Rectangle belowRows(Rectangle area, int rowsEnd) {
    int lowest = area.y + Math.max(0, area.height - BANNER_HEIGHT - 2 * Theme.EDGE);
    int top = Math.clamp(rowsEnd, area.y, lowest);
    return new Rectangle(area.x, top, area.width, area.y + area.height - top);
  }

  /**
   * Paints a dot with a word and a sentence below it in the middle of an area.
   *
   * @param gc where to paint
   * @param area the area
   * @param health the dot
   * @param title a few words
   * @param sentence what is so and what would help; wrapped
   */
  public void message(GC gc, Rectangle area, Health health, String title, String sentence) {
    TextLayout text = wrapped(gc, area, sentence);
    gc.setFont(theme.font(Face.BODY_STRONG));
    Point size = gc.textExtent(title);
    int gap = sentence.isBlank() ? 0 : Theme.STEP;
    int below = sentence.isBlank() ? 0 : text.getBounds().height;
    int top = area.y + Math.max(0, (area.height - size.y - gap - below) / 2);
    int lead = HealthDot.SIZE + 2 * Theme.STEP;
    int left = area.x + (area.width - size.x - lead) / 2;
    HealthDot.paint(gc, theme, health, left + HealthDot.SIZE / 2, top + size.y / 2 + 1);
    gc.setForeground(theme.color(Role.TEXT));
    gc.drawText(title, left + lead, top, true);
    gc.setForeground(theme.color(Role.DIM));
    text.draw(gc, area.x + (area.width - text.getWidth()) / 2, top + size.y + gap);
    text.dispose();
  }

  /**
   * Paints a dot and a few words on a pill at the top of an area.
   *
   * @param gc where to paint
   * @param area the area
   * @param health the dot
   * @param words for example {@code stale 2.1 s}
   */
  public void banner(GC gc, Rectangle area, Health health, String words) {
    gc.setFont(theme.font(Face.SMALL));
    int lead = HealthDot.SIZE + 3 * Theme.STEP;
    String fitting = TextFit.shorten(gc, words, area.width - lead - 2 * Theme.STEP - 2 * Theme.EDGE);
    Point size = gc.textExtent(fitting);
    int width = size.x + lead + 2 * Theme.STEP;
    int left = area.x + (area.width - width) / 2;
    int top = area.y + Theme.EDGE;
    pill(gc, new Rectangle(left, top, width, BANNER_HEIGHT));
    HealthDot.paint(gc, theme, health, left + Theme.EDGE, top + BANNER_HEIGHT / 2);
    gc.setForeground(theme.color(health.role()));
    gc.drawText(fitting, left + lead + Theme.STEP / 2, top + (BANNER_HEIGHT - size.y) / 2, true);
  }

  /**
   * Paints the ground on which words over content are legible.
   *
   * @param gc where to paint
   * @param area where the words stand
   */
  public void pill(GC gc, Rectangle area) {
    gc.setAntialias(SWT.ON);
    gc.setAlpha(GROUND_ALPHA);
    gc.setBackground(theme.color(Role.GROUND));
    gc.fillRoundRectangle(area.x, area.y, area.width, area.height, 2 * Theme.STEP, 2 * Theme.STEP);
    gc.setAlpha(OPAQUE);
    gc.setForeground(theme.color(Role.LINE));
    gc.setLineWidth(1);
    gc.drawRoundRectangle(area.x, area.y, area.width, area.height, 2 * Theme.STEP, 2 * Theme.STEP);
  }

  private TextLayout wrapped(GC gc, Rectangle area, String sentence) {
    TextLayout text = new TextLayout(gc.getDevice());
    text.setFont(theme.font(Face.BODY));
    text.setText(sentence.substring(0, Math.min(LONGEST, sentence.length())));
    text.setAlignment(SWT.CENTER);
    text.setWidth(Math.max(1, Math.min(LINE_WIDTH, area.width - 2 * Theme.EDGE)));
    return text;
  }

  private static String title(InputState state) {
    return switch (state) {
      case InputState.Unconnected u -> "Not connected";
      case InputState.Waiting w -> "Waiting for data";
      case InputState.Failed f -> "Failed";
      default -> "";
    };
  }
}
