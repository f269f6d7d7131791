package org.robotui.uic.camera.internal;

import java.util.Optional;
import org.eclipse.swt.widgets.Control;
import org.robotui.entity.image.ColorMap;
import org.robotui.entity.image.Legend;
import org.robotui.entity.image.Picture;
import org.robotui.ui.control.PopupMenu;

/** The menu of the view, made when opened and disposed when closed. Display thread. */
final class CameraMenu {
  private final CameraSurface surface;
  private final CameraChoices choices;

  CameraMenu(CameraSurface surface, CameraChoices choices) {
    this.surface = surface;
    this.choices = choices;
  }

  /** Opens it at the pointer. */
  void open(Control control, Optional<Picture> picture) {
    PopupMenu menu = new PopupMenu(control, surface::redraw);
    CameraOptions options = choices.options();
    for (ZoomMode mode : ZoomMode.values()) {
      menu.radio(mode.label(), options.zoom() == mode, () -> surface.see(mode));
    }
    menu.check("Smooth pixels", options.smooth(), on -> choices.set(CameraOptions.SMOOTH, on));
    menu.line();
    menu.check("Pixel under the pointer\tI", options.readOut(), on -> choices.set(CameraOptions.READ_OUT, on));
    menu.check("Details\tD", options.details(), on -> choices.set(CameraOptions.DETAILS, on));
    picture.flatMap(Picture::legend).ifPresent(legend -> numbers(menu, options, legend));
    menu.line();
    menu.push("Copy picture", picture.isPresent(), surface::copy);
    menu.push("Save picture\u2026", picture.isPresent(), () -> surface.save(Saver.Part.COLORS));
    if (picture.flatMap(Picture::numbers).isPresent()) {
      menu.push("Save numbers, 16 bit\u2026", () -> surface.save(Saver.Part.NUMBERS));
    }
    menu.open();
  }

  private void numbers(PopupMenu menu, CameraOptions options, Legend legend) {
    menu.line();
    PopupMenu colors = menu.under("Colours");
    Optional<ColorMap> chosen = options.rendering().map();
    colors.radio("Automatic", chosen.isEmpty(), () -> choices.map(Optional.empty()));
    for (ColorMap map : ColorMap.values()) {
      colors.radio(map.label(), chosen.equals(Optional.of(map)), () -> choices.map(Optional.of(map)));
    }
    colors.line();
    colors.check("Reversed", options.rendering().reversed(), on -> choices.set(CameraOptions.REVERSED, on));
    boolean follows = options.rendering().range().isEmpty();
    menu.radio("Range follows the picture\tR", follows, () -> choices.range(Optional.empty()));
    menu.radio("Range as it is now\tR", !follows, () -> choices.range(Optional.of(legend.span())));
    menu.check("Depth in metres", options.rendering().depth(), on -> choices.set(CameraOptions.DEPTH, on));
    menu.check("Legend\tL", options.legend(), on -> choices.set(CameraOptions.LEGEND, on));
  }
}
