package org.robotui.uic.graph.internal.model;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.Browser;
import org.robotui.api.port.CallException;
import org.robotui.api.port.SourceId;

/** A robot whose connections a test sets. */
public final class Robots implements Browser {
  private final List<Link> links = new ArrayList<>();
  private Optional<String> failure = Optional.empty();

  /** As a browse port gives it. */
  public BrowseInput.Robot robot(String name) {
    return new BrowseInput.Robot(new SourceId(name, "graph"), this);
  }

  /** Connects: {@code node > topic} or {@code node < topic}. */
  public Robots tie(String... ties) {
    for (String tie : ties) {
      String[] words = tie.split(" ");
      links.add(new Link(words[0], words[2], words[1].equals(">")));
    }
    return this;
  }

  public void fail(String why) {
    failure = Optional.of(why);
  }

  /** A mobile base as many are. */
  public static Robots base() {
    return new Robots().tie("/laser/driver > /scan", "/base/driver > /odom", "/base/driver > /tf",
        "/base/driver < /cmd_vel", "/amcl < /scan",
        "/amcl < /tf", "/amcl > /tf", "/amcl > /amcl_pose", "/map_server > /map", "/amcl < /map", "/move_base < /map",
        "/move_base < /scan",
        "/move_base < /odom", "/move_base > /cmd_vel", "/move_base > /move_base/plan", "/move_base < /move_base/goal",
        "/mission > /move_base/goal", "/mission < /move_base/plan", "/mission < /amcl_pose",
        "/camera/driver > /camera/image_raw",
        "/camera/driver > /camera/camera_info", "/camera/rectify < /camera/image_raw",
        "/camera/rectify < /camera/camera_info",
        "/camera/rectify > /camera/image_rect", "/detector < /camera/image_rect", "/detector > /detections",
        "/mission < /detections",
        "/rosout < /rosout", "/mission > /rosout", "/robotui_77 < /scan", "/move_base > /move_base/unheard");
  }

  /** As large as it gets: nodes in namespaces, with topics each, every one taken by the node of the next. */
  public static Robots many(int nodes, int topics) {
    Robots robot = new Robots();
    for (int i = 0; i < topics; i++) {
      int from = i % nodes;
      robot.tie("/part" + from / 10 + "/node" + from + " > /part" + from / 10 + "/topic" + i,
          "/part" + (from + 7) % nodes / 10 + "/node" + (from + 7) % nodes + " < /part" + from / 10 + "/topic" + i);
    }
    return robot;
  }

  @Override
  public List<Item> list(Kind kind) throws CallException {
    if (failure.isPresent()) {
      throw new CallException(failure.get());
    }
    return links.stream().map(Link::topic).distinct().sorted().map(topic -> new Item(kind, topic, "pkg/Type")).toList();
  }

  @Override
  public List<Link> links() {
    return List.copyOf(links);
  }

  @Override
  public Description describe(Item item) throws CallException {
    throw new CallException("not asked for here");
  }

  @Override
  public Optional<Object> parameter(String name) {
    return Optional.empty();
  }

  @Override
  public void setParameter(String name, Object value) throws CallException {
    throw new CallException("not asked for here");
  }

  @Override
  public List<Tunable> tunables(Item item) throws CallException {
    throw new CallException("not asked for here");
  }

  @Override
  public List<Tunable> setTunables(Item item, Map<String, Object> values) throws CallException {
    throw new CallException("not asked for here");
  }
}
