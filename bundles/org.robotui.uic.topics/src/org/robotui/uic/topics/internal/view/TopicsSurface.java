package org.robotui.uic.topics.internal.view;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.Browser.Kind;
import org.robotui.api.port.SourceId;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.UiContext;
import org.robotui.ui.ViewSurface;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.DetailSplit;
import org.robotui.ui.control.FilterField;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.topics.internal.TopicsOptions;
import org.robotui.uic.topics.internal.model.Catalog;
import org.robotui.uic.topics.internal.model.Key;
import org.robotui.uic.topics.internal.model.TopicsModel;
import org.robotui.uic.topics.internal.model.TopicsViewState;
import org.robotui.uic.topics.internal.model.Wishes;

/**
 * What is seen of the view: kinds and filter above, the list at the left, all about the selected thing at the right.
 * Display thread.
 */
public final class TopicsSurface implements ViewSurface {
  private static final int FILTER_WIDTH = 180;
  private static final int SIDE_BY_SIDE_FROM = 640;
  private static final int SHARE_BESIDE = 58;
  private static final int SHARE_ABOVE = 50;

  private final UiContext context;
  private final TopicsModel model;
  private final Supplier<TopicsOptions> options;
  private final Composite root;
  private final Composite bar;
  private final Map<Kind, QuietButton> sections = new EnumMap<>(Kind.class);
  private final FilterField filter;
  private final NoticeLine notice;
  private final DetailSplit split;
  private final Shelf shelf;
  private final TopicDetailPane detail;
  private Optional<Awaited> awaited = Optional.empty();

  /** Something that is to be shown as soon as the robot has said that it is there. */
  private record Awaited(Supplier<Optional<Key>> key, TopicDetailPane.Leaf leaf) {}

  /**
   * Makes the controls.
   *
   * @param ruic the RUIC whose streams the topics are
   * @param subjects the menus of its ports and nodes
   */
  public TopicsSurface(Composite parent, UiContext context, TopicsModel model, Supplier<TopicsOptions> options,
      String ruic,
      SubjectMenu subjects) {
    this.context = context;
    this.model = model;
    this.options = options;
    Theme theme = context.theme();
    root = Boxes.root(parent, theme, this::focus);
    bar = Boxes.bar(root, theme, Catalog.KINDS.size() + 1);
    for (Kind kind : Catalog.KINDS) {
      sections.put(kind, new QuietButton(bar, theme, () -> section(kind)).text(TopicText.section(kind)));
    }
    filter = new FilterField(bar, theme, "Filter", this::filter);
    filter.setLayoutData(Boxes.end(FILTER_WIDTH));
    notice = new NoticeLine(root, theme, Face.BODY);
    split = new DetailSplit(root, theme, SHARE_ABOVE).besideFrom(SIDE_BY_SIDE_FROM, SHARE_BESIDE);
    shelf = new Shelf(split.parts(), theme, new Acts(), ruic, subjects);
    detail = new TopicDetailPane(split.parts(), theme, model, this::follow, ruic, subjects);
    listen();
    resume(model.look().wishes());
  }

  private boolean focus() {
    return shelf.table().list().control().setFocus();
  }

  @Override
  public Control control() {
    return root;
  }

  /** Shows what the last tick prepared. */
  public void refresh() {
    if (root.isDisposed()) {
      return;
    }
    if (root.isVisible()) {
      model.seen(System.nanoTime());
    }
    watch();
    reach();
    TopicsViewState look = model.look();
    sections(look);
    shelf.show(look);
    detail.show(look);
    // Where there is nothing to select, the room is not halved.
    split.detail(StateView.showsContent(look.state()) || look.wishes().selected().isPresent());
    if (Boxes.seen(notice.control(), !look.notice().isEmpty())) {
      root.layout();
    }
    notice.show(Health.WARNING, look.notice());
    context.note(note(look));
  }

  /** Shows the topic of a stream: its messages, or what is known of it. */
  public void show(SourceId stream, boolean echo) {
    await(new Awaited(() -> model.topic(stream), echo ? TopicDetailPane.Leaf.ECHO : TopicDetailPane.Leaf.ABOUT));
  }

  /** Shows a program. */
  public void showNode(String name) {
    await(new Awaited(() -> model.node(name), TopicDetailPane.Leaf.ABOUT));
  }

  private void await(Awaited next) {
    awaited = Optional.of(next);
    refresh();
  }

  /** Goes to what was asked for, once it is known. */
  private void reach() {
    awaited.ifPresent(wanted -> wanted.key().get().ifPresent(key -> {
      awaited = Optional.empty();
      follow(key);
      detail.open(wanted.leaf());
    }));
  }

  Shelf shelf() {
    return shelf;
  }

  TopicDetailPane detail() {
    return detail;
  }

  FilterField filterField() {
    return filter;
  }

  void section(Kind kind) {
    shelf.section(kind);
    sections.forEach((each, button) -> button.checked(each == kind));
    list(kind, filter.words());
  }

  /** What the list does not show is not selected, so that nothing is echoed that nobody sees chosen. */
  private void list(Kind kind, String words) {
    model.list(kind, words);
    if (model.selected().isEmpty()) {
      shelf.table().list().selectNone();
      select(Optional.empty());
    }
  }

  /** Goes to a thing of any kind. */
  void follow(Key key) {
    if (model.look().wishes().section() != key.kind()) {
      section(key.kind());
    }
    filter.words("");
    shelf.table().list().select(key);
    select(Optional.of(key));
  }

  private void select(Optional<Key> key) {
    awaited = awaited.filter(wanted -> key.isEmpty());
    model.select(key);
    detail.select(key);
    detail.show(model.look());
  }

  private void filter(String words) {
    shelf.highlight(words);
    list(shelf.section(), words);
  }

  /** What is repeated goes on only while the user works here. */
  private void watch() {
    if (model.look().speech().hertz().isPresent()) {
      if (isFocused()) {
        model.speaker().watched(System.nanoTime());
      } else {
        model.speaker().stop("the view lost the focus");
      }
    }
  }

  private boolean isFocused() {
    Control at = root.getDisplay().getFocusControl();
    while (at != null && at != root) {
      at = at.getParent();
    }
    return at == root;
  }

  private void sections(TopicsViewState look) {
    boolean changed = false;
    for (Kind kind : Catalog.KINDS) {
      QuietButton button = sections.get(kind);
      int before = button.computeSize(SWT.DEFAULT, SWT.DEFAULT).x;
      button.text(TopicText.section(kind) + "  " + look.counts().getOrDefault(kind, 0))
          .checked(kind == look.wishes().section());
      changed |= button.computeSize(SWT.DEFAULT, SWT.DEFAULT).x != before;
    }
    if (changed) {
      bar.layout();
    }
  }

  private static String note(TopicsViewState look) {
    String shown = look.rows().size() == look.total() ? "" : look.rows().size() + " of " + look.total();
    String streams =
        look.streams() == 0 ? "" : look.streams() + (look.streams() == 1 ? " stream taken" : " streams taken");
    return shown.isEmpty() || streams.isEmpty() ? shown + streams : shown + " \u00b7 " + streams;
  }

  private void listen() {
    model.sorting(shelf::sorted);
    filter.onDown(() -> shelf.table().list().control().setFocus());
    root.addListener(SWT.Resize, e -> arrange());
    root.addListener(SWT.Dispose, e -> model.gone());
  }

  /** A control that is made anew goes on where the one before it was. */
  private void resume(Wishes wishes) {
    shelf.section(wishes.section());
    filter.words(wishes.filter());
    wishes.selected().ifPresent(shelf.table().list()::select);
    detail.select(wishes.selected());
  }

  /** Where there is little width, the filter has less of it. */
  private void arrange() {
    boolean beside = root.getClientArea().width >= SIDE_BY_SIDE_FROM;
    GridData data = (GridData) filter.getLayoutData();
    data.widthHint = beside ? FILTER_WIDTH : FILTER_WIDTH / 2;
    bar.layout();
  }

  /** What the user does to rows. */
  private final class Acts implements Shelf.Acts {
    @Override
    public void select(Optional<Key> key) {
      TopicsSurface.this.select(key);
    }

    @Override
    public void open(Key key) {
      TopicsSurface.this.select(Optional.of(key));
      detail.open();
    }

    @Override
    public void measure(Key key, boolean on) {
      model.measure(key, on, options.get().measured());
    }

    @Override
    public void reorder() {
      model.sorting(shelf::sorted);
    }

    @Override
    public void find() {
      filter.focus();
    }
  }
}
