/**
 * The client side of SmartSoft's communication patterns: push, send, query and event, and what is made of queries
 * (state, parameter, wiring). Each client is one connection to one service. Connecting and querying block, all else
 * does not. Objects are bytes here; {@link org.robotui.smartsoft.object.CommType} reads and makes them.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.smartsoft.client;
