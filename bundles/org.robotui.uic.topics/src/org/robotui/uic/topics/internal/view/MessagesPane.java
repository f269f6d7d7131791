package org.robotui.uic.topics.internal.view;

import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.InputState;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.Clipboards;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RecordTree;
import org.robotui.ui.control.RowTable;
import org.robotui.ui.show.RecordYaml;
import org.robotui.uic.topics.internal.model.MessageContent;
import org.robotui.uic.topics.internal.model.MessageContent.FieldChange;
import org.robotui.uic.topics.internal.model.MessageListing;
import org.robotui.uic.topics.internal.model.TimedMessage;
import org.robotui.uic.topics.internal.view.BytesLines.Line;

/**
 * All messages of a topic of a recording around the position of the timeline, and of the one that holds there its
 * fields, its bytes, and what is another than in the message before. Display thread.
 */
final class MessagesPane {
  /** What is shown of a message. */
  enum Page {
    FIELDS("Fields"), CHANGES("Changes"), BYTES("Bytes");

    private final String label;

    Page(String label) {
      this.label = label;
    }
  }

  private static final int LIST_SHARE = 2;
  private static final int CONTENT_SHARE = 3;
  /** With less, the list lies above the message. */
  private static final int ROOM_BESIDE = 560;
  private static final double SECONDS = 1e-9;

  private final Composite root;
  private final NoticeLine figures;
  private final RowTable<TimedMessage> list;
  private final Map<Page, QuietButton> tabs = new EnumMap<>(Page.class);
  private final StackLayout pages = new StackLayout();
  private final Composite stack;
  private final RecordTree fields;
  private final RowTable<FieldChange> changes;
  private final RowTable<Line> bytes;
  private MessageListing shown = MessageListing.NOTHING;

  MessagesPane(Composite parent, Theme theme) {
    root = Boxes.panel(parent, theme, 1);
    Composite bar = Boxes.bar(root, theme, 2 + Page.values().length);
    figures = new NoticeLine(bar, theme, Face.SMALL_FIGURES);
    for (Page each : Page.values()) {
      tabs.put(each, new QuietButton(bar, theme, () -> turn(each)).text(each.label));
    }
    new QuietButton(bar, theme, this::copy).icon(Icon.COPY).hint("Copy the message as text");
    SashForm body = Boxes.split(root, theme, SWT.HORIZONTAL);
    body.setLayoutData(Boxes.fill());
    list = new RowTable<>(body, theme, columns(), TimedMessage::key);
    list.list().named("Messages of the recording")
        .onSelect(rows -> rows.stream().findFirst().filter(row -> !isCurrent(row)).ifPresent(row -> shown.seek(row)));
    stack = new Composite(body, SWT.NONE);
    stack.setBackground(theme.color(Role.PANEL));
    stack.setLayout(pages);
    fields = new RecordTree(stack, theme);
    changes = new RowTable<>(stack, theme, changeColumns(), FieldChange::path);
    changes.list().named("Changes since the message before");
    bytes = new RowTable<>(stack, theme, BytesLines.columns(), Line::offset);
    bytes.list().named("Bytes of the message");
    turn(Page.FIELDS);
    body.setWeights(LIST_SHARE, CONTENT_SHARE);
    body.addListener(SWT.Resize,
        e -> body.setOrientation(body.getSize().x < ROOM_BESIDE ? SWT.VERTICAL : SWT.HORIZONTAL));
  }

  Control control() {
    return root;
  }

  RowTable<TimedMessage> list() {
    return list;
  }

  RowTable<FieldChange> changes() {
    return changes;
  }

  RowTable<Line> bytes() {
    return bytes;
  }

  void turn(Page next) {
    tabs.forEach((each, tab) -> tab.checked(each == next));
    pages.topControl = switch (next) {
      case FIELDS -> fields.control();
      case CHANGES -> changes.control();
      case BYTES -> bytes.control();
    };
    stack.layout();
    content();
  }

  void show(MessageListing listing) {
    if (listing == shown) {
      return;
    }
    shown = listing;
    list.show(listing.rows());
    if (!listing.obstacle().isEmpty()) {
      list.list().message(Health.NONE, "No messages are listed", listing.obstacle());
    } else if (listing.rows().isEmpty()) {
      list.list().message(Health.WAITING, "Reading the recording", "");
    } else {
      list.list().noMessage();
    }
    listing.current().ifPresentOrElse(this::mark, () -> list.list().selectNone());
    content();
  }

  private void mark(TimedMessage message) {
    if (list.list().selected().stream().noneMatch(message::equals)) {
      list.list().select(message.key());
    }
  }

  private boolean isCurrent(TimedMessage row) {
    return shown.current().filter(row::equals).isPresent();
  }

  private void content() {
    Optional<MessageContent> content = shown.content();
    figures.show(Health.NONE, content.map(MessagesPane::figures).orElse(""));
    fields(content);
    Optional<List<FieldChange>> differs = content.flatMap(MessageContent::changes);
    changes.show(differs.orElse(List.of()));
    if (differs.filter(all -> !all.isEmpty()).isPresent()) {
      changes.list().noMessage();
    } else {
      changes.list().message(Health.NONE, content.isEmpty() ? ""
          : differs.isPresent() ? "Nothing has changed"
              : "There is no message before it",
          "");
    }
    bytes.show(content.flatMap(MessageContent::bytes).map(BytesLines::of).orElse(List.of()));
    if (content.filter(each -> each.bytes().isEmpty()).isPresent()) {
      bytes.list().message(Health.NONE, "Its bytes are not known", "");
    } else {
      bytes.list().noMessage();
    }
  }

  private void fields(Optional<MessageContent> content) {
    if (content.isPresent()) {
      fields.noMessage();
      fields.state(new InputState.Live(0, 0));
      fields.show(content.get().record());
    } else {
      fields.clear();
      fields.message(Health.NONE, shown.rows().isEmpty() || shown.current().isPresent() ? "" : "No message until then",
          "");
    }
  }

  private static String figures(MessageContent content) {
    int size = content.size();
    int seen = content.bytes().map(first -> first.size()).orElse(0);
    String cut = seen < size ? ", the first " + TopicText.bytes(seen, "B") + " are shown" : "";
    return (size == 0 ? "" : TopicText.bytes(size, "B") + cut)
        + content.changes().map(all -> (size == 0 ? "" : "  \u00b7  ") + all.size()
            + (all.size() == 1 ? " field has changed" : " fields have changed")).orElse("");
  }

  private void copy() {
    shown.content().ifPresent(content -> Clipboards.copy(RecordYaml.of(content.record())));
  }

  private List<Column<TimedMessage>> columns() {
    return List.of(
        Column.<TimedMessage>figures("Time", row -> seconds(row.time() - start(), 3)).width(100),
        Column.<TimedMessage>figures("After", row -> row.gap().isPresent() ? seconds(row.gap().getAsLong(), 3) : "")
            .width(90).role(Role.DIM).hint(row -> "Since the message before it"),
        Column.<TimedMessage>figures("Size",
            row -> row.size().isPresent() ? TopicText.bytes(row.size().getAsInt(), "B") : "").width(80).role(Role.DIM));
  }

  /** Times count from the start of the recording, as on the timeline. */
  private long start() {
    return shown.history().map(history -> history.timeline().state().span()
        .map(span -> span.start() - history.offset()).orElseGet(() -> history.span().start())).orElse(0L);
  }

  private static String seconds(long nanos, int decimals) {
    return String.format(Locale.ROOT, "%." + decimals + "f s", nanos * SECONDS);
  }

  private static List<Column<FieldChange>> changeColumns() {
    return List.of(Column.<FieldChange>words("Field", FieldChange::path).weight(1.4),
        Column.<FieldChange>values("Before", FieldChange::before).role(Role.DIM).weight(1),
        Column.<FieldChange>values("Now", FieldChange::now).weight(1));
  }
}
