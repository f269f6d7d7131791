/** Services as ports: what is made of their objects, who wants them, and what drives the robot. */
package org.robotui.rfic.smartsoft.internal.feed;
