package org.robotui.ui.control;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.port.InputState;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

/** Shows the controls side by side, for a person to look at: {@code ControlGallery dark|light [LEFT TOP]}. */
final class ControlGallery {
  private final Shell shell;
  private final Theme theme;
  private final int left;
  private final int top;

  private ControlGallery(Shell shell, Theme theme, int left, int top) {
    this.shell = shell;
    this.left = left;
    this.top = top;
    this.theme = theme;
  }

  public static void main(String[] arguments) {
    Display display = new Display();
    Theme theme = Themes.of(display, arguments[0]);
    Shell shell = new Shell(display, SWT.NO_TRIM);
    int left = arguments.length > 2 ? Integer.parseInt(arguments[1]) : 0;
    int top = arguments.length > 2 ? Integer.parseInt(arguments[2]) : 0;
    shell.setBounds(0, 0, 1600, 1000);
    shell.setBackground(theme.color(Role.LINE));
    new ControlGallery(shell, theme, left, top).fill();
    shell.open();
    while (!shell.isDisposed()) {
      if (!display.readAndDispatch()) {
        display.sleep();
      }
    }
  }

  private void fill() {
    cell(0, 0, 560, 320, this::topics);
    cell(566, 0, 300, 320, this::topics);
    cell(0, 326, 560, 200, part -> {
      RowTable<Line> table = topics(part);
      table.list().state(new InputState.Stale(2.1, "the link is lost"));
    });
    cell(566, 326, 300, 200, part -> {
      RowTable<Line> table = topics(part);
      table.list().message(Health.NONE, "No topics", "Connect to a robot to see what it offers.");
    });
    cell(872, 0, 440, 480, this::form);
    cell(872, 486, 440, 510, part -> {
      RecordForm form = form(part);
      type(form, "mode", "300");
      type(form, "speed", "MAX_SPEED");
      type(form, "label", "to the door");
      type(form, "covariance", "1 2 3");
    });
    cell(1318, 0, 282, 480, this::form);
    cell(0, 532, 430, 460, this::tree);
    cell(436, 532, 430, 460, part -> {
      RecordTree tree = tree(part);
      tree.expandAll();
      tree.highlight("pos");
    });
  }

  private RecordForm form(Composite part) {
    RecordForm form = new RecordForm(part, theme);
    form.shape(Shapes.TASK);
    FormArray way = (FormArray) form.body().model().root().fields().get(8);
    way.add();
    form.body().build();
    return form;
  }

  private static void type(RecordForm form, String path, String words) {
    ((Text) form.body().rows().get(path).input()).setText(words);
  }

  private RecordTree tree(Composite part) {
    RecordTree tree = new RecordTree(part, theme);
    tree.show(Records.scan(360, 0.25));
    tree.list().select("header.stamp");
    return tree;
  }

  private RowTable<Line> topics(Composite part) {
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    part.setLayout(layout);
    RowTable<Line> table = new RowTable<>(part, theme, Line.COLUMNS, Line::topic);
    FilterField field = new FilterField(part, theme, "Filter topics", table::highlight);
    field.moveAbove(null);
    field.setLayoutData(new GridData(SWT.END, SWT.TOP, false, false));
    table.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    table.order(new RowOrder<>(Line.COLUMNS.getFirst(), false)).list().several().named("Topics")
        .drag(line -> Optional.of(line.topic()));
    table.show(table.sorted(Line.many()));
    table.list().select("/robot1/camera/image_raw");
    field.words("camera");
    return table;
  }

  private void cell(int x, int y, int width, int height, Consumer<Composite> fill) {
    Composite part = new Composite(shell, SWT.NONE);
    part.setBackground(theme.color(Role.PANEL));
    part.setBounds(x - left, y - top, width, height);
    part.setLayout(new FillLayout());
    fill.accept(part);
    part.layout(true, true);
  }

  private record Line(String topic, String type, double rate, Health health) {
    static final List<Column<Line>> COLUMNS = List.of(
        Column.<Line>words("Topic", Line::topic).weight(3).dot(Line::health).order(Comparator.comparing(Line::topic)),
        Column.<Line>words("Type", Line::type).weight(2).role(Role.DIM).from(420)
            .order(Comparator.comparing(Line::type)),
        Column.<Line>figures("Rate", line -> String.format("%.1f Hz", line.rate()))
            .order(Comparator.comparing(Line::rate)),
        Column.<Line>figures("Bandwidth", line -> String.format("%.0f kB/s", line.rate() * 14)).role(Role.DIM).width(96)
            .from(380));

    static List<Line> many() {
      return IntStream.range(0, 200).mapToObj(Line::of).toList();
    }

    private static Line of(int i) {
      List<String> names =
          List.of("scan", "odom", "camera/image_raw", "camera/camera_info", "move_base/local_costmap/costmap_updates");
      List<String> types =
          List.of("sensor_msgs/LaserScan", "nav_msgs/Odometry", "sensor_msgs/Image", "sensor_msgs/CameraInfo",
              "map_msgs/OccupancyGridUpdate");
      return new Line("/robot" + i / 5 + "/" + names.get(i % 5), types.get(i % 5), 10 + i * 7 % 41,
          Health.values()[i % 6]);
    }
  }
}
