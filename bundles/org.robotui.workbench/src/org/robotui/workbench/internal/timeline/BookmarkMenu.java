package org.robotui.workbench.internal.timeline;

import java.io.IOException;
import java.util.Comparator;
import org.eclipse.jface.dialogs.MessageDialog;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.config.AtomicFile;
import org.robotui.api.config.WriteFailure;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.Timeline;
import org.robotui.ui.control.NameDialog;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.SaveDialog;

/** What can be done with bookmarks. Display thread only. */
record BookmarkMenu(Control over, BarState bar, Timeline timeline) {
  /** Notes a time at once, and then asks for a note: without one, it is noted all the same. */
  void add(long time) {
    Bookmark mark = new Bookmark(time, "");
    timeline.mark(mark);
    rename(mark);
  }

  private void rename(Bookmark mark) {
    NameDialog.ask(over, "Note for the bookmark", mark.note())
        .ifPresent(note -> timeline.mark(new Bookmark(mark.time(), note)));
  }

  /** All of them, each with what can be done with it. */
  PopupMenu all() {
    PopupMenu menu = new PopupMenu(over);
    menu.push("Add Bookmark", () -> add(bar.state().position()));
    menu.push("Export Bookmarks\u2026", !bar.state().bookmarks().isEmpty(), this::export);
    menu.line();
    bar.state().bookmarks().stream().sorted(Comparator.comparingLong(Bookmark::time))
        .forEach(mark -> of(menu.under(words(mark)), mark));
    return menu;
  }

  private void export() {
    String table = BookmarkTable.of(bar.state().bookmarks(), bar.all().start());
    SaveDialog.ask(over, "Export Bookmarks", "bookmarks.csv", "*.csv").ifPresent(file -> {
      try {
        AtomicFile.write(file, table);
      } catch (IOException e) {
        MessageDialog.openError(over.getShell(), "Export Bookmarks",
            file + " could not be written: " + WriteFailure.reason(e));
      }
    });
  }

  /** What can be done with one. */
  void of(PopupMenu menu, Bookmark mark) {
    menu.push("Go There", () -> timeline.seek(mark.time()));
    menu.push("Rename\u2026", () -> rename(mark));
    menu.push("Remove", () -> timeline.unmark(mark.time()));
  }

  private String words(Bookmark mark) {
    String time = TimeWords.seconds(mark.time() - bar.all().start());
    return mark.note().isEmpty() ? time : time + "  " + mark.note();
  }
}
