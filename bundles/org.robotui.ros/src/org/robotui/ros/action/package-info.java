/**
 * Clients and servers of actions (actionlib) of any type. {@link org.robotui.ros.action.Actions} finds the actions of a
 * graph, {@link org.robotui.ros.action.ActionClient} sends goals to one of them and follows each goal to its end as
 * actionlib's own clients do; a goal whose server is lost ends, too. A goal is sent once, and only to a server that
 * listens. {@link org.robotui.ros.action.ActionServer} serves an action to such clients.
 */
package org.robotui.ros.action;
