package org.robotui.script.internal.engine;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.robotui.data.record.DynamicRecord;

/**
 * A record as an object of a script: its fields can be read and listed. What is written into it is the script's own
 * affair; the record does not change. A field is converted when it is read for the first time, since a picture or a
 * point cloud has millions of numbers of which a script mostly wants none.
 */
final class RecordView extends ScriptableObject {
  private static final long serialVersionUID = 1L;

  private final transient DynamicRecord record;
  private final transient Map<String, Object> read = new HashMap<>();

  RecordView(DynamicRecord record, Scriptable scope) {
    super(scope, ScriptableObject.getObjectPrototype(scope));
    this.record = record;
  }

  @Override
  public String getClassName() {
    return "Object";
  }

  @Override
  public Object get(String name, Scriptable start) {
    if (!record.fields().contains(name) || super.has(name, start)) {
      return super.get(name, start);
    }
    return read.computeIfAbsent(name, field -> record.field(field)
        .map(new ToScript(Context.getCurrentContext(), getParentScope())::of).orElse(NOT_FOUND));
  }

  @Override
  public boolean has(String name, Scriptable start) {
    return record.fields().contains(name) && record.field(name).isPresent() || super.has(name, start);
  }

  @Override
  public Object[] getIds() {
    Object[] own = super.getIds();
    Object[] all = record.fields().stream().filter(name -> record.field(name).isPresent()).toArray();
    Object[] both = Arrays.copyOf(all, all.length + own.length);
    System.arraycopy(own, 0, both, all.length, own.length);
    return own.length == 0 ? all : Arrays.stream(both).distinct().toArray();
  }
}
