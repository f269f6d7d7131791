package org.robotui.uic.gps.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.widgets.Control;
import org.robotui.entity.gps.GeoPoint;
import org.robotui.entity.gps.GeoText;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.PopupMenu;
import org.robotui.uic.gps.internal.GpsOptions;
import org.robotui.uic.gps.internal.model.GpsModel;
import org.robotui.uic.gps.internal.model.Receiver;

/** The menu of the view, made when opened and disposed when closed. Display thread. */
final class GpsMenu {
  private final GpsCanvas view;
  private final GpsModel model;
  private final GpsChoices choices;

  GpsMenu(GpsCanvas view, GpsModel model, GpsChoices choices) {
    this.view = view;
    this.model = model;
    this.choices = choices;
  }

  /** Opens it at the pointer. */
  void open(Control control, Optional<GeoPoint> place) {
    PopupMenu menu = new PopupMenu(control, view::refresh);
    place.ifPresent(p -> place(menu, p));
    receivers(menu);
    view(menu);
    menu.open();
  }

  private void place(PopupMenu menu, GeoPoint place) {
    menu.push("Copy " + GeoText.decimal(place), () -> Clipboards.copy(GeoText.plain(place)));
    menu.push("Copy " + GeoText.sexagesimal(place), () -> Clipboards.copy(GeoText.sexagesimal(place)));
    menu.push("Measure from here", () -> view.measureFrom(place));
    menu.push("Centre here", () -> view.center(place));
    menu.push("Set the origin here", () -> choices.origin(Optional.of(place)));
    menu.line();
  }

  private void receivers(PopupMenu menu) {
    List<Receiver> receivers = model.snapshot().receivers();
    GpsOptions options = choices.options();
    for (Receiver receiver : receivers) {
      PopupMenu sub = menu.under(receiver.name());
      boolean followed =
          options.follow() && model.snapshot().followed(options.followed()).equals(Optional.of(receiver));
      sub.check("Follow", followed, on -> {
        if (on) {
          choices.follow(receiver.id());
        } else {
          choices.follow(false);
        }
      });
      receiver.place().ifPresent(p -> {
        sub.push("Copy " + GeoText.decimal(p), () -> Clipboards.copy(GeoText.plain(p)));
        sub.push("Set the origin there", () -> choices.origin(Optional.of(p)));
        sub.push("Measure from there", () -> view.measureFrom(p));
      });
    }
    menu.line();
  }

  private void view(PopupMenu menu) {
    GpsOptions options = choices.options();
    menu.push("Show all\t0", () -> view.mover().fit());
    menu.check("Measure\tM", view.measuring(), on -> view.toggleRuler());
    menu.check("Origin at the first fix", options.origin().isEmpty(),
        on -> choices.origin(on ? Optional.empty() : model.snapshot().plane().map(p -> p.origin())));
    menu.push("Clear the tracks", model::clear);
    menu.line();
    menu.check("Degrees, minutes, seconds\tD", options.sexagesimal(), choices::sexagesimal);
    menu.check("Layers\tL", view.listOpen(), on -> view.toggleList());
  }
}
