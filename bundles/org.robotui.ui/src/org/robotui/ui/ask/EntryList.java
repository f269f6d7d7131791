package org.robotui.ui.ask;

import java.util.Comparator;
import java.util.List;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ask.AskModel.Shown;
import org.robotui.ui.ask.Catalogue.Entry;
import org.robotui.ui.ask.Catalogue.Listing;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.RowOrder;
import org.robotui.ui.control.RowTable;

/** What can be asked, to choose from. Display thread. */
final class EntryList {
  private static final int TYPES_FROM = 340;

  private final AskWords words;
  private final RowTable<Entry> table;
  private final FilterField filter;
  private final Consumer<Entry> choose;

  EntryList(Composite parent, Theme theme, AskWords words, AskModel model, Runnable changed) {
    this.words = words;
    choose = entry -> {
      model.choose(entry);
      changed.run();
    };
    Composite box = Boxes.panel(parent, theme, 1);
    Composite bar = Boxes.inset(box, theme, 1, Theme.STEP * 2, Theme.STEP + 1);
    bar.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    Column<Entry> names = Column.<Entry>words("Name", e -> e.item().name()).weight(3)
        .order(Comparator.comparing((Entry e) -> e.item().name()));
    Column<Entry> types = Column.<Entry>words("Type", e -> e.item().type()).weight(2).role(Role.DIM).from(TYPES_FROM)
        .order(Comparator.comparing((Entry e) -> e.item().type()));
    filter = new FilterField(bar, theme, "Filter " + words.things(), text -> {
      model.filter(text);
      changed.run();
    });
    filter.setLayoutData(Boxes.line(SWT.DEFAULT));
    table =
        new RowTable<>(box, theme, List.of(names, types), e -> e).order(new RowOrder<>(names, false)).onOrder(changed);
    table.control().setLayoutData(Boxes.fill());
    table.list().named(words.things()).onFind(filter::focus)
        .onSelect(rows -> rows.stream().findFirst().ifPresent(choose));
    filter.onDown(() -> table.list().control().setFocus());
  }

  void show(Shown shown) {
    table.show(table.sorted(shown.entries()));
    table.highlight(shown.filter());
    if (shown.entries().isEmpty()) {
      explain(shown);
    } else {
      table.list().noMessage();
    }
  }

  private void explain(Shown shown) {
    Listing listing = shown.listing();
    if (!listing.problems().isEmpty()) {
      table.list().message(Health.BAD, "No answer", String.join("; ", listing.problems()));
    } else if (!listing.asked()) {
      table.list().message(Health.WAITING, "Asking", "The robot is asked for its " + words.things() + ".");
    } else if (listing.robots() == 0) {
      table.list().message(Health.NONE, "No robot",
          "No robot interface that is connected can list " + words.things() + ".");
    } else if (listing.entries().isEmpty()) {
      table.list().message(Health.NONE, "No " + words.things(), "The robot offers none now.");
    } else {
      table.list().message(Health.NONE, "No match",
          "None of " + listing.entries().size() + " contains the words of the filter.");
    }
  }

  void find(Entry entry) {
    filter.words("");
    choose.accept(entry);
    table.list().select(entry);
    setFocus();
  }

  boolean setFocus() {
    return table.list().control().setFocus();
  }
}
