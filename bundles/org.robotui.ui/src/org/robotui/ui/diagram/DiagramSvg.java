package org.robotui.ui.diagram;

import java.util.Locale;
import java.util.stream.Collectors;
import org.eclipse.swt.graphics.RGB;
import org.robotui.ui.Palette;
import org.robotui.ui.Role;

/** Diagrams as SVG, in the colours of a theme. Pure, for all threads. */
public final class DiagramSvg {
  private static final int CORNER = 4;

  private DiagramSvg() {}

  /**
   * Writes.
   *
   * @param diagram what
   * @param palette its colours
   * @return the text of the file
   */
  public static String write(Diagram diagram, Palette palette) {
    StringBuilder out = new StringBuilder();
    out.append(String.format(Locale.ROOT,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-16 -16 %.0f %.0f\" font-family=\"sans-serif\">%n",
        diagram.width() + 32, diagram.height() + 32));
    out.append(
        "<defs><marker id=\"head\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\">"
            + "<path d=\"M0 0L8 4L0 8z\" fill=\"context-stroke\"/></marker></defs>\n");
    out.append(String.format(Locale.ROOT, "<rect x=\"-16\" y=\"-16\" width=\"100%%\" height=\"100%%\" fill=\"%s\"/>%n",
        color(palette.rgb(Role.PANEL))));
    diagram.boxes().stream().filter(box -> box.form() == Box.Form.GROUP).forEach(box -> box(out, box, palette));
    diagram.wires().forEach(wire -> wire(out, wire, palette));
    diagram.boxes().stream().filter(box -> box.form() != Box.Form.GROUP).forEach(box -> box(out, box, palette));
    return out.append("</svg>\n").toString();
  }

  private static void box(StringBuilder out, Box box, Palette palette) {
    double round = box.form() == Box.Form.PILL ? box.height() / 2 : CORNER;
    out.append(String.format(Locale.ROOT,
        "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" rx=\"%.1f\" fill=\"%s\" stroke=\"%s\"/>%n",
        box.x(), box.y(), box.width(), box.height(), round,
        color(Palette.mix(palette.rgb(box.role()), palette.rgb(Role.PANEL), 0.2)), color(palette.rgb(box.role()))));
    if (box.form() == Box.Form.GROUP) {
      text(out, box.x() + 10, box.y() + 15, 11, "start", palette.rgb(Role.DIM), box.title());
    } else {
      boolean noted = !box.note().isEmpty();
      double middle = box.x() + box.width() / 2;
      text(out, middle, box.y() + (noted ? box.height() * 0.34 : box.height() / 2) + 4, 12.5, "middle",
          palette.rgb(Role.TEXT), box.title());
      if (noted) {
        text(out, middle, box.y() + box.height() * 0.8, 11, "middle", palette.rgb(Role.DIM), box.note());
      }
    }
  }

  private static void wire(StringBuilder out, Wire wire, Palette palette) {
    String points = wire.corners().stream().map(c -> String.format(Locale.ROOT, "%.1f,%.1f", c.x(), c.y()))
        .collect(Collectors.joining(" "));
    out.append(String.format(Locale.ROOT,
        "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\"%s marker-end=\"url(#head)\"/>%n",
        points, color(palette.rgb(wire.role())), wire.dashed() ? " stroke-dasharray=\"5 4\"" : ""));
    if (!wire.label().isEmpty()) {
      text(out, wire.middle().x(), wire.middle().y() - 3, 11, "middle", palette.rgb(Role.TEXT), wire.label());
    }
  }

  private static void text(StringBuilder out, double x, double y, double size, String anchor, RGB color, String words) {
    out.append(String.format(Locale.ROOT,
        "<text x=\"%.1f\" y=\"%.1f\" font-size=\"%.1f\" text-anchor=\"%s\" fill=\"%s\">%s</text>%n",
        x, y, size, anchor, color(color), escaped(words)));
  }

  private static String escaped(String words) {
    return words.codePoints().filter(c -> c >= ' ').mapToObj(c -> switch (c) {
      case '<' -> "&lt;";
      case '>' -> "&gt;";
      case '&' -> "&amp;";
      default -> Character.toString(c);
    }).collect(Collectors.joining());
  }

  private static String color(RGB rgb) {
    return String.format(Locale.ROOT, "#%02x%02x%02x", rgb.red, rgb.green, rgb.blue);
  }
}
