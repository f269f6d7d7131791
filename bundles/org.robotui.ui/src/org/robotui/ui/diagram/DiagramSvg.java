package org.robotui.ui.diagram;

import java.util.Locale;
import java.util.stream.Collectors;
import org.robotui.ui.Palette;
import org.robotui.ui.Role;
import org.robotui.ui.SvgWriter;
import org.robotui.ui.SvgWriter.Anchor;

/** Diagrams as SVG, in the colours of a theme. Pure, for all threads. */
public final class DiagramSvg {
  private static final int CORNER = 4;
  private static final int MARGIN = 16;

  private DiagramSvg() {}

  /**
   * Writes.
   *
   * @param diagram what
   * @param palette its colours
   * @return the text of the file
   */
  public static String write(Diagram diagram, Palette palette) {
    SvgWriter out = new SvgWriter(-MARGIN, -MARGIN, diagram.width() + 2 * MARGIN, diagram.height() + 2 * MARGIN,
        palette.rgb(Role.PANEL));
    out.element(
        "<defs><marker id=\"head\" viewBox=\"0 0 8 8\" refX=\"8\" refY=\"4\" markerWidth=\"7\" markerHeight=\"7\" orient=\"auto\">"
            + "<path d=\"M0 0L8 4L0 8z\" fill=\"context-stroke\"/></marker></defs>");
    diagram.boxes().stream().filter(box -> box.form() == Box.Form.GROUP).forEach(box -> box(out, box, palette));
    diagram.wires().forEach(wire -> wire(out, wire, palette));
    diagram.boxes().stream().filter(box -> box.form() != Box.Form.GROUP).forEach(box -> box(out, box, palette));
    return out.end();
  }

  private static void box(SvgWriter out, Box box, Palette palette) {
    double round = box.form() == Box.Form.PILL ? box.height() / 2 : CORNER;
    out.element("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" rx=\"%.1f\" fill=\"%s\" stroke=\"%s\"/>",
        box.x(), box.y(), box.width(), box.height(), round,
        SvgWriter.color(Palette.mix(palette.rgb(box.role()), palette.rgb(Role.PANEL), 0.2)),
        SvgWriter.color(palette.rgb(box.role())));
    if (box.form() == Box.Form.GROUP) {
      out.text(box.x() + 10, box.y() + 15, 11, Anchor.START, palette.rgb(Role.DIM), box.title());
    } else {
      boolean noted = !box.note().isEmpty();
      double middle = box.x() + box.width() / 2;
      out.text(middle, box.y() + (noted ? box.height() * 0.34 : box.height() / 2) + 4, 12.5, Anchor.MIDDLE,
          palette.rgb(Role.TEXT), box.title());
      if (noted) {
        out.text(middle, box.y() + box.height() * 0.8, 11, Anchor.MIDDLE, palette.rgb(Role.DIM), box.note());
      }
    }
  }

  private static void wire(SvgWriter out, Wire wire, Palette palette) {
    String points = wire.corners().stream().map(c -> String.format(Locale.ROOT, "%.1f,%.1f", c.x(), c.y()))
        .collect(Collectors.joining(" "));
    out.element("<polyline points=\"%s\" fill=\"none\" stroke=\"%s\"%s marker-end=\"url(#head)\"/>", points,
        SvgWriter.color(palette.rgb(wire.role())), wire.dashed() ? " stroke-dasharray=\"5 4\"" : "");
    if (!wire.label().isEmpty()) {
      out.text(wire.middle().x(), wire.middle().y() - 3, 11, Anchor.MIDDLE, palette.rgb(Role.TEXT), wire.label());
    }
  }
}
