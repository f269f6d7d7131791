package org.robotui.entity.marker.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.ValueType;
import org.robotui.data.Data;
import org.robotui.data.marker.InteractiveMarkerSet;
import org.robotui.gl.display.Display;
import org.robotui.gl.display.DisplayContext;
import org.robotui.gl.display.DisplayType;

/** Shows interactive markers, and tells their servers what users do with them. */
@Component(service = DisplayType.class)
public final class InteractiveType implements DisplayType {
  static final String DESCRIPTIONS = "descriptions";
  static final Schema SCHEMA =
      Schema.of(Setting.of(DESCRIPTIONS, new ValueType.Flag(), true,
          "Whether what a marker says of itself is written above it."));

  @Override
  public String id() {
    return "interactive";
  }

  @Override
  public String label() {
    return "Interactive markers";
  }

  @Override
  public String help() {
    return "Shows markers of the robot that are dragged, turned and clicked, and tells the robot of it.";
  }

  @Override
  public List<Class<? extends Data>> accepts() {
    return List.of(InteractiveMarkerSet.class);
  }

  @Override
  public Schema schema() {
    return SCHEMA;
  }

  @Override
  public Display create(DisplayContext context) {
    return new InteractiveDisplay(context);
  }
}
