package org.robotui.web.tree;

import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Builds a tree of what a parser reads. */
final class JsonTree {

  private final JsonParser parser;
  private final TreeBudget budget = new TreeBudget();

  JsonTree(JsonParser parser) {
    this.parser = parser;
  }

  /** The value at whose first token the parser is. */
  Object value(int depth) throws IOException {
    TreeBudget.depth(depth);
    budget.value();
    JsonToken token = Optional.ofNullable(parser.currentToken()).orElseThrow(() -> new TreeException("nothing"));
    return switch (token) {
      case START_OBJECT -> object(depth);
      case START_ARRAY -> array(depth);
      case VALUE_STRING -> parser.getText();
      case VALUE_TRUE -> true;
      case VALUE_FALSE -> false;
      case VALUE_NULL -> JsonNull.NULL;
      case VALUE_NUMBER_INT -> whole();
      case VALUE_NUMBER_FLOAT -> parser.getDoubleValue();
      default -> throw new TreeException("no value where one is expected");
    };
  }

  private Object whole() throws IOException {
    return parser.getNumberType() == JsonParser.NumberType.BIG_INTEGER
        ? parser.getBigIntegerValue()
        : (Object) parser.getLongValue();
  }

  private Map<String, Object> object(int depth) throws IOException {
    Map<String, Object> members = new LinkedHashMap<>();
    while (parser.nextToken() == JsonToken.FIELD_NAME) {
      String name = parser.currentName();
      parser.nextToken();
      members.put(name, value(depth + 1));
    }
    return members;
  }

  private Object array(int depth) throws IOException {
    NumberArray numbers = new NumberArray();
    JsonToken token = parser.nextToken();
    while (isNumber(token)) {
      add(numbers, token);
      token = parser.nextToken();
    }
    if (token == JsonToken.END_ARRAY && numbers.size() > 0) {
      return numbers.array();
    }
    List<Object> items = new ArrayList<>();
    for (int i = 0; i < numbers.size(); i++) {
      budget.value();
      items.add(numbers.at(i));
    }
    for (; token != JsonToken.END_ARRAY; token = parser.nextToken()) {
      items.add(value(depth + 1));
    }
    return items;
  }

  /** A null among numbers is one that JSON cannot hold; integers beyond 64 bits are objects. */
  private boolean isNumber(JsonToken token) throws IOException {
    return token == JsonToken.VALUE_NUMBER_FLOAT || token == JsonToken.VALUE_NULL
        || token == JsonToken.VALUE_NUMBER_INT && parser.getNumberType() != JsonParser.NumberType.BIG_INTEGER;
  }

  private void add(NumberArray numbers, JsonToken token) throws IOException {
    switch (token) {
      case VALUE_NUMBER_INT -> numbers.add(parser.getLongValue());
      case VALUE_NULL -> numbers.add(Double.NaN);
      default -> numbers.add(parser.getDoubleValue());
    }
  }
}
