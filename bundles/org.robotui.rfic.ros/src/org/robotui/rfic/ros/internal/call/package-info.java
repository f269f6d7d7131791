/** Services, parameters and nodes, for calling and browsing. */
package org.robotui.rfic.ros.internal.call;
